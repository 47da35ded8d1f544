#pragma once

#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/tape.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// A contribution with the solution structure put in: the slots are affine in derivatives of the
/// undetermined functions,
///
///     d_s = g_s + Σ_m M_{s,m} ∂^{β_m} Ψ_{k_m},
///
/// and the coefficients M, g, C, b are the roots of one tape. Which of them vanish or are constant
/// is known here, once; at points of quadrature there are only arrays of numbers.
class CompiledIntegrand {
 public:
  /// A derivative ∂^derivative Ψ_unknown that occurs.
  struct BasisDerivative {
    int unknown = 0;
    MultiIndex derivative{};
  };
  /// M_{slot, basis derivative} as a number of a scalar.
  struct MapEntry {
    int slot = 0, basis_derivative = 0, scalar = 0;
  };
  struct NormalTerm {
    MultiIndex normal{};
    int scalar = 0;
  };
  struct StiffnessEntry {
    int row = 0, column = 0;
    std::vector<NormalTerm> terms;
    bool mirrored = true;  ///< C(column, row) is the same; else this is a coupling, row the test's
  };
  struct LoadEntry {
    int slot = 0;
    std::vector<NormalTerm> terms;
  };
  /// An array of values over points: a root of the tape or a constant.
  struct Scalar {
    int root = -1;
    double constant = 0;
    std::string name;  // for messages
  };

  /// `structures[c]` is component c. Throws `InvalidArgument` when a slot asks for a component that
  /// does not exist, or normals occur in the volume.
  CompiledIntegrand(const Contribution& contribution, std::span<const Structure> structures,
                    int dimension);

  const Contribution& contribution() const { return contribution_; }
  int slot_count() const { return static_cast<int>(inhomogeneous_.size()); }
  const std::vector<BasisDerivative>& basis_derivatives() const { return basis_derivatives_; }
  const std::vector<MapEntry>& map() const { return map_; }
  /// g_s as a scalar, or −1 if it vanishes.
  const std::vector<int>& inhomogeneous() const { return inhomogeneous_; }
  const std::vector<StiffnessEntry>& stiffness() const { return stiffness_; }
  const std::vector<LoadEntry>& load() const { return load_; }
  /// The field that must be ≥ 0, or −1.
  int where() const { return where_; }
  const std::vector<Scalar>& scalars() const { return scalars_; }
  const Tape& tape() const { return *tape_; }

 private:
  int scalar(const Field& field, const std::string& name, std::vector<Field>& roots);
  int slot(const Slot& slot, std::span<const Structure> structures, std::vector<Field>& roots);
  int basis_derivative(int unknown, const MultiIndex& derivative);

  Contribution contribution_;
  std::vector<Slot> slots_;
  std::vector<BasisDerivative> basis_derivatives_;
  std::vector<MapEntry> map_;
  std::vector<int> inhomogeneous_;
  std::vector<StiffnessEntry> stiffness_;
  std::vector<LoadEntry> load_;
  int where_ = -1;
  std::vector<Scalar> scalars_;
  std::unique_ptr<const Tape> tape_;
};

}  // namespace rfm
