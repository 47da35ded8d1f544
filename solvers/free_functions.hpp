#pragma once

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "core/field.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/dense_assembly.hpp"
#include "solvers/kernel.hpp"

namespace rfm {

/// Functions that nothing may fix in a problem: a constant of each unknown that no structure holds,
/// and rotations of the first unknowns, one per dimension, if none of them is held. Whether an
/// equation leaves them free, its matrix tells (solvers/kernel.hpp).
class FreeFunctions {
 public:
  FreeFunctions(std::span<const Structure> structures, std::span<const TensorProductSpace> spaces);
  /// The same in functions of the whole domain, where these have the constant, or one that is
  /// linear along an axis, among them.
  FreeFunctions(std::span<const Structure> structures, const GlobalSpaces& spaces);

  /// As columns, in the splines of all unknowns.
  const Eigen::MatrixXd& coefficients() const { return coefficients_; }
  /// What a kernel of these weights (by column) leaves free: "the level of p, rotations of u, v".
  std::string text(const Eigen::MatrixXd& kernel, const std::vector<std::string>& names) const;
  /// That there is no solution, and why.
  std::string text(const UnbalancedLoads& loads, const std::vector<std::string>& names) const;
  /// The unknowns without what they have of the kernel: orthogonal to its functions in L2, so that
  /// means, and mean rotations, are zero.
  std::vector<Field> without(const Eigen::MatrixXd& kernel, std::vector<Field> unknowns,
                             const DomainRule& rule) const;

 private:
  struct Function {
    std::vector<int> unknowns;      // one of a constant, two of a rotation
    std::vector<Field> components;  // by unknown
  };
  /// Of each unknown, the coefficients of an axis' coordinate, or of 1 for −1; or none.
  using Coefficients = std::function<std::optional<Eigen::VectorXd>(int unknown, int axis)>;
  void collect(std::span<const Structure> structures, const std::vector<Eigen::Index>& first,
               int dimension, const Coefficients& of);
  void add(Function function, Eigen::VectorXd coefficients);

  std::vector<Function> functions_;
  Eigen::MatrixXd coefficients_;
};

}  // namespace rfm
