#include "core/contour_nesting.hpp"

#include "core/contour.hpp"

namespace rfm {
namespace {

// Which contours hold which others, and how many hold each.
struct Nesting {
  std::vector<std::vector<bool>> holds;
  std::vector<int> depth;

  explicit Nesting(const std::vector<std::vector<Point>>& contours)
      : holds(contours.size(), std::vector<bool>(contours.size(), false)),
        depth(contours.size(), 0) {
    for (std::size_t i = 0; i < contours.size(); ++i)
      for (std::size_t j = 0; j < contours.size(); ++j)
        if (i != j && winds_around(contours[i], contours[j][0])) {
          holds[i][j] = true;
          ++depth[j];
        }
  }
  // Contour c without those directly inside it, and so on.
  BooleanExpression expression(std::size_t c,
                               const std::vector<BooleanExpression>& contours) const {
    BooleanExpression result = contours[c];
    for (std::size_t inner = 0; inner < contours.size(); ++inner)
      if (holds[c][inner] && depth[inner] == depth[c] + 1)
        result = result & !expression(inner, contours);
    return result;
  }
};

}  // namespace

BooleanExpression nested_expression(const std::vector<std::vector<Point>>& contours,
                                    const std::vector<BooleanExpression>& expressions) {
  const Nesting nesting(contours);
  BooleanExpression whole = BooleanExpression::constant(false);
  for (std::size_t c = 0; c < contours.size(); ++c)
    if (nesting.depth[c] == 0) whole = whole | nesting.expression(c, expressions);
  return whole;
}

}  // namespace rfm
