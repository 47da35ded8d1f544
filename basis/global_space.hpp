#pragma once

#include <array>

#include "core/box.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// Functions for an undetermined function Ψ that all live on the whole domain: polynomials
/// (basis/tensor_polynomials.hpp), or any others that a class of the user's own evaluates:
///
///     class Plane final : public GlobalSpace {          // 1, x, y
///       ...
///     };
///
/// Assembly asks for values at points of quadrature and makes dense matrices; nothing else is known
/// of the functions. They should be linearly independent on the domain, and of moderate size there:
/// systems are scaled by their diagonals, but a basis that is nearly dependent loses digits.
class GlobalSpace {
 public:
  virtual ~GlobalSpace() = default;

  virtual int dimension() const = 0;
  /// The number of functions.
  virtual int size() const = 0;
  /// ∂^derivative of every function at `count` points, `coordinates[axis]` holding their
  /// coordinates: that of function f at point q goes to `values[f + q * size()]`.
  virtual void evaluate(const std::array<const double*, 3>& coordinates, int count,
                        const MultiIndex& derivative, double* values) const = 0;
  /// Where functions may be evaluated.
  virtual Box valid() const = 0;
};

}  // namespace rfm
