#pragma once

#include <vector>

#include "core/box.hpp"
#include "core/field.hpp"
#include "problems/problem.hpp"
#include "solvers/equations.hpp"

namespace rfm {

/// What an eigenproblem found: λ in K φ = λ M φ from the shift of the study on, ascending, multiple
/// ones repeated.
struct EigenResult {
  std::vector<double> values;
  std::vector<double> residuals;  ///< of the pairs, see `EigenPair`
  /// The modes φ, all components of each, with ∫ φᵀ m φ = 1.
  std::vector<std::vector<Field>> modes;
  /// How many eigenvalues lie from the shift to `upper`: all of them were found.
  int present = 0;
  double upper = 0;

  /// √λ / 2π; 0 where λ is 0 but for rounding, not a number for λ < 0.
  std::vector<double> frequencies() const;
};

/// Eigenvalues and modes of equations whose mass is m: values and loads of conditions do not
/// matter, the structures are taken without them (`homogeneous_part`).
///
/// Modes have a sign, and those of one eigenvalue a basis, that do not depend on the solver: with
/// the moments ∫ m φ_c ξ^α, ξ the coordinates from the middle of `box`, in ascending order of α and
/// for each of the components c, the first moment that does not vanish in the eigenspace belongs to
/// the first mode alone and is positive, the next one that is independent of it to the first two,
/// and so on. On a disk the modes of a pair are those of cos mθ and sin mθ; of a body that nothing
/// holds the first are translations along x, y, …, then rotations.
///
/// A component may have no mass where its stiffness determines it from the others. Throws
/// `ComputationError` where not as many eigenvalues exist or can be found, or the stiffness is not
/// symmetric.
EigenResult find_modes(const Equations& equations, const Study& study, const Box& box);

/// The largest relative error of the eigenvalues with respect to the exact ones, as many as given;
/// of an eigenvalue zero the error relative to the largest.
double eigenvalue_error(const std::vector<double>& values, const std::vector<double>& exact);

}  // namespace rfm
