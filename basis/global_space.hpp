#pragma once

#include <span>

#include <array>

#include "core/field_source.hpp"
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
  /// Rigorous bounds of Σ c_i f_i and its slopes over a box within that of `valid`. A space that
  /// does not override this tells nothing, and its combinations serve as data, not as geometry.
  virtual FunctionBounds bounds(std::span<const double>, const Box&) const {
    FunctionBounds nothing;
    nothing.value = Interval::entire();
    nothing.gradient.fill(Interval::entire());
    nothing.smooth = false;
    return nothing;
  }
};

}  // namespace rfm
