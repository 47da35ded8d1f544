#pragma once

#include <optional>

#include "core/field.hpp"

namespace rfm {

/// f(x, y) = even + x · odd for x ≥ 0, both in terms of x² alone.
struct EvenAndOddParts {
  Field even = 0.0, odd = 0.0;

  bool is_even() const { return odd.is_constant(0); }
};

/// The parts of `f` as far as its expression shows them, with `square` put in for x² and `height`
/// for y: of sums, products, whole powers and quotients by even functions any parts; of other
/// functions those of even arguments, which are even (exp(−x²), √(x² + y²)). Nothing otherwise
/// (sin x), nor for sampled functions.
std::optional<EvenAndOddParts> even_and_odd(const Field& f, const Field& square,
                                            const Field& height);

}  // namespace rfm
