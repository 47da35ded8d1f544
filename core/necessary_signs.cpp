#include "core/necessary_signs.hpp"

namespace rfm {

std::vector<NecessarySign> necessary_signs(const RegionEvaluator& region, const Box& box) {
  const BooleanExpression& expression = region.region().expression();
  std::vector<Truth> signs;
  for (int k = 0; k < region.primitive_count(); ++k) {
    const Interval value = region.level(k).value_bounds(box);
    signs.push_back(value.low >= 0 ? Truth::yes : value.high < 0 ? Truth::no : Truth::unknown);
  }
  std::vector<NecessarySign> necessary;
  for (int k = 0; k < region.primitive_count(); ++k) {
    if (signs[k] != Truth::unknown) continue;
    signs[k] = Truth::no;
    const bool must_be_true = expression.evaluate(signs) == Truth::no;
    signs[k] = Truth::yes;
    const bool must_be_false = expression.evaluate(signs) == Truth::no;
    signs[k] = Truth::unknown;
    if (must_be_true != must_be_false) necessary.push_back({k, must_be_true ? 1.0 : -1.0});
  }
  return necessary;
}

}  // namespace rfm
