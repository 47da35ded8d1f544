#include "problems/pictures/field_pixels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <memory>

#include "core/primitives.hpp"
#include "core/spline_field.hpp"
#include "problems/pictures/region_pixels.hpp"

namespace rfm {
namespace {

const Box square{2, {-1, -1, 0}, {1, 1, 0}};
const PixelWindow window = PixelWindow::around({2, {-1.1, -1.1, 0}, {1.1, 1.1, 0}}, 440, 440);

FieldPicture sampled(const std::vector<Field>& components, const Region& region,
                     bool with_slope = true) {
  return sample_field(components, sample_region(RegionEvaluator(region), window),
                      {window, square, with_slope});
}

TEST(FieldPixels, HoldTheFieldAndItsSlopeAtEveryPixelInside) {
  const Field u = field([](auto x, auto y) { return sin(2 * x) * exp(y); });
  const FieldPicture picture = sampled({u}, circle({0, 0}, 0.9).named("disk"));
  int inside = 0;
  for (int y = 0; y < 440; ++y)
    for (int x = 0; x < 440; ++x) {
      const std::size_t i = 440 * y + x;
      if (picture.region.distance[i] < 0) continue;
      ++inside;
      const Point p = window.centre(x, y);
      EXPECT_NEAR(picture.value[i], std::sin(2 * p[0]) * std::exp(p[1]), 1e-14);
      EXPECT_NEAR(picture.slope[i],
                  window.pixel_size * std::exp(p[1]) *
                      std::hypot(2 * std::cos(2 * p[0]), std::sin(2 * p[0])),
                  1e-14);
    }
  EXPECT_GT(inside, 100000);
}

TEST(FieldPixels, OfAVectorHoldItsLengthAndComponents) {
  const FieldPicture picture =
      sampled({-1.0 * y_coordinate(), x_coordinate()}, circle({0, 0}, 0.9).named("disk"), false);
  EXPECT_TRUE(picture.slope.empty());
  const std::size_t i = 440 * 100 + 300;
  const Point p = window.centre(300, 100);
  EXPECT_NEAR(picture.vector_x[i], -p[1], 1e-15);
  EXPECT_NEAR(picture.vector_y[i], p[0], 1e-15);
  EXPECT_NEAR(picture.value[i], std::hypot(p[0], p[1]), 1e-15);
}

TEST(FieldPixels, AreDefinedOnTheBoundaryOfAFieldThatEndsThere) {
  // A spline on the grid of the very box, and a function that has no value outside.
  const Grid grid(square, {4, 4, 1});
  std::vector<double> ones(static_cast<std::size_t>(SplineField::coefficient_count(grid, 2)), 1.0);
  const Field spline = field(std::make_shared<SplineField>(grid, 2, ones));
  const Field root = sqrt(1.0 - pow(x_coordinate(), 2));
  for (const Field& u : {spline, root}) {
    const FieldPicture picture = sampled({u}, box({-1, -1}, {1, 1}).named("box"));
    for (std::size_t i = 0; i < picture.value.size(); ++i)
      if (picture.region.covered(i) > 0) {
        EXPECT_TRUE(std::isfinite(picture.value[i]));
      }
  }
}

TEST(FieldPixels, TakeANeighboursValueWhereTheBoundaryHasNone) {
  // √(r² − x² − y²) ends on the circle itself: pixels whose centres lie outside have no value.
  const Field u = sqrt(0.81 - pow(x_coordinate(), 2) - pow(y_coordinate(), 2));
  const FieldPicture picture = sampled({u}, circle({0, 0}, 0.9).named("disk"));
  int mended = 0;
  for (std::size_t i = 0; i < picture.value.size(); ++i) {
    if (picture.region.covered(i) <= 0) continue;
    EXPECT_TRUE(std::isfinite(picture.value[i]));
    if (picture.region.distance[i] < 0) {
      ++mended;
      EXPECT_LT(picture.value[i], 0.2);  // at most √(2 · 0.9 · 3 pixels)
    }
  }
  EXPECT_GT(mended, 500);
}

TEST(FieldPixels, KeepWhatHasNoValueAndRangesIgnoreIt) {
  const Field u = sqrt(x_coordinate());
  const FieldPicture picture = sampled({u}, circle({0, 0}, 0.9).named("disk"));
  const std::size_t left = 440 * 220 + 100, right = 440 * 220 + 340;
  EXPECT_TRUE(std::isnan(picture.value[left]));
  EXPECT_NEAR(picture.value[right], std::sqrt(window.centre(340, 220)[0]), 1e-15);
  const ValueRange range = range_of(picture).value();
  EXPECT_NEAR(range.low, 0, 0.1);
  EXPECT_NEAR(range.high, std::sqrt(0.9), 0.01);
}

}  // namespace
}  // namespace rfm
