#include "core/contour_nesting.hpp"

#include <gmock/gmock.h>

#include <memory>

namespace rfm {
namespace {

std::vector<Point> square(double radius, const Point& center = {}) {
  const double x = center[0], y = center[1], r = radius;
  return {{x - r, y - r}, {x + r, y - r}, {x + r, y + r}, {x - r, y + r}};
}

TEST(ContourNesting, AlternatesBetweenInsideAndHolesWhateverTheOrder) {
  const std::vector<double> radii{2, 5, 1, 4, 3};  // nested squares
  std::vector<std::vector<Point>> contours;
  std::vector<BooleanExpression> insides;
  for (std::size_t i = 0; i < radii.size(); ++i) {
    contours.push_back(square(radii[i]));
    insides.push_back(BooleanExpression::variable(static_cast<int>(i)));
  }
  const BooleanExpression whole = nested_expression(contours, insides);
  for (double x = 0.5; x < 7; x += 1) {
    const auto signs = std::make_unique<bool[]>(radii.size());
    int around = 0;
    for (std::size_t i = 0; i < radii.size(); ++i) around += signs[i] = x < radii[i];
    EXPECT_EQ(whole.evaluate(std::span<const bool>(signs.get(), radii.size())), around % 2 == 1)
        << x;
  }
}

TEST(ContourNesting, JoinsContoursBesideEachOtherEachWithItsHoles) {
  const std::vector<std::vector<Point>> contours{square(1, {5, 0}), square(3), square(2, {6, 0}),
                                                 square(1)};
  std::vector<BooleanExpression> v;
  for (int i = 0; i < 4; ++i) v.push_back(BooleanExpression::variable(i));
  const BooleanExpression whole = nested_expression(contours, v);
  const BooleanExpression expected = (v[1] & !v[3]) | (v[2] & !v[0]);
  for (int bits = 0; bits < 16; ++bits) {
    const bool signs[] = {(bits & 1) != 0, (bits & 2) != 0, (bits & 4) != 0, (bits & 8) != 0};
    EXPECT_EQ(whole.evaluate(std::span<const bool>(signs)),
              expected.evaluate(std::span<const bool>(signs)));
  }
}

}  // namespace
}  // namespace rfm
