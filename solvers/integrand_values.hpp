#pragma once

#include <array>
#include <span>
#include <vector>

#include "solvers/compiled_integrand.hpp"

namespace rfm {

/// Points at which an integrand is evaluated; `normals` are empty in the volume.
struct IntegrandPoints {
  std::array<std::vector<double>, 3> coordinates, normals;
  std::vector<double> weights;

  int size() const { return static_cast<int>(weights.size()); }
  void clear();
};

/// The coefficients of a compiled integrand at a set of points, with the weights of quadrature put
/// in. One per thread.
class IntegrandValues {
 public:
  IntegrandValues(const CompiledIntegrand& integrand, int capacity);

  /// Evaluates everything at up to `capacity` points; weights become zero where the contribution is
  /// restricted. Throws `ComputationError` naming the coefficient and the point where a value is
  /// not finite.
  void evaluate(IntegrandPoints& points, double time, std::span<const double> parameters);

  /// M entry `entry` at all points.
  const double* map(int entry) const { return scalar(integrand_.map()[entry].scalar); }
  /// w C entry `entry`.
  const double* stiffness(int entry) const { return &stiffness_[std::size_t(entry) * capacity_]; }
  /// w Σ_s M_{s,m} (b_s − Σ_t C_{s,t} g_t): what multiplies ∂^{β_m} Ψ in the right-hand side.
  const double* load(int basis_derivative) const {
    return &load_[std::size_t(basis_derivative) * capacity_];
  }
  bool has_load() const { return has_load_; }
  /// Σ w (½ gᵀ C g − bᵀ g) over the points first … last − 1.
  double constant(int first, int last) const;

 private:
  const double* scalar(int number) const { return &scalars_[std::size_t(number) * capacity_]; }
  void restrict_to_where(IntegrandPoints& points);
  void require_finite(const IntegrandPoints& points, int root_scalar, double time,
                      std::span<const double> parameters) const;
  void weigh(const IntegrandPoints& points, const std::vector<CompiledIntegrand::NormalTerm>& terms,
             double* result) const;

  const CompiledIntegrand& integrand_;
  int capacity_;
  bool has_load_ = false;
  Tape::Workspace workspace_;
  std::vector<double> scalars_, stiffness_, load_, slot_load_, constant_;
};

}  // namespace rfm
