#include "core/conditional_r_functions.hpp"

#include "core/r_equivalence.hpp"

namespace rfm {

Field conditional_conjunction(const Field& x, const Field& y, const Field& s) {
  // Where x + y > 0 as (2xy − s) / (x + y + √…): no difference of nearly equal numbers.
  const Field root = sqrt(x * x + y * y + s);
  return select(apply(Operation::less, {0.0, x + y}), (2 * x * y - s) / (x + y + root),
                x + y - root);
}

Field conditional_disjunction(const Field& x, const Field& y, const Field& s) {
  return -conditional_conjunction(-x, -y, s);
}

Field quotient_conjunction(const Field& x, const Field& y) { return equivalence(x, y, 2); }

}  // namespace rfm
