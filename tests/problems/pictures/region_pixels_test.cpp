#include "problems/pictures/region_pixels.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/primitives.hpp"

namespace rfm {
namespace {

PixelWindow unit_window(int pixels) {  // [−1.5, 1.5]²
  return PixelWindow::around({2, {-1.5, -1.5, 0}, {1.5, 1.5, 0}}, pixels, pixels);
}

// The area that is painted, in the units of the plane.
double area(const RegionPixels& pixels, const PixelWindow& window) {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.distance.size(); ++i) sum += pixels.covered(i);
  return sum * window.pixel_size * window.pixel_size;
}

// The length of the boundary that is drawn, from the ink of a line.
double length(const RegionPixels& pixels, const PixelWindow& window, double line_width) {
  double sum = 0;
  for (std::size_t i = 0; i < pixels.distance.size(); ++i) sum += pixels.on_line(i, line_width);
  return sum * window.pixel_size / line_width;
}

TEST(PixelWindow, MapsPixelsAndPlaneOntoEachOther) {
  const PixelWindow window = PixelWindow::around({2, {0, 1, 0}, {4, 3, 0}}, 400, 300);
  EXPECT_EQ(window.pixel_size, 0.01);
  EXPECT_NEAR(window.left, 0, 1e-12);
  EXPECT_NEAR(window.top, 3.5, 1e-12);  // centred on the box
  const Point centre = window.centre(7, 11);
  const PixelPosition place = window.place(centre);
  EXPECT_NEAR(place.x, 7.5, 1e-9);
  EXPECT_NEAR(place.y, 11.5, 1e-9);
}

TEST(RegionPixels, CoverTheAreaOfADiskAndItsBoundaryItsCircumference) {
  const RegionEvaluator disk(circle({0.013, -0.021}, 1).named("disk"));
  for (const int pixels : {100, 300, 777}) {
    const PixelWindow window = unit_window(pixels);
    const RegionPixels sampled = sample_region(disk, window);
    EXPECT_NEAR(area(sampled, window), std::numbers::pi, 0.5 / (pixels * std::sqrt(pixels)));
    EXPECT_NEAR(length(sampled, window, 2), 2 * std::numbers::pi, 0.02);
  }
}

TEST(RegionPixels, DistancesAreThoseFromTheBoundary) {
  const RegionEvaluator disk(circle({0, 0}, 1).named("disk"));
  const PixelWindow window = unit_window(500);
  const RegionPixels sampled = sample_region(disk, window, 5);
  for (int y = 0; y < 500; ++y)
    for (int x = 0; x < 500; ++x) {
      const Point point = window.centre(x, y);
      const double exact = (1 - std::hypot(point[0], point[1])) / window.pixel_size;
      const double found = sampled.distance[500 * y + x];
      if (std::isinf(found)) {
        EXPECT_GT(std::abs(exact), 4.5);
        EXPECT_EQ(found > 0, exact > 0);
        EXPECT_EQ(sampled.primitive[500 * y + x], -1);
      } else {
        // To first order: the second is d²/2r, at most 25 / 2 · 0.006 pixels.
        EXPECT_NEAR(found, exact, 0.09);
        EXPECT_EQ(sampled.primitive[500 * y + x], 0);
      }
    }
}

TEST(RegionPixels, CornersAreSharpAndPiecesAreTold) {
  // A square turned by 45°: distances are piecewise linear, areas exact but for the corners.
  const double r = std::sqrt(0.5);
  const Region square =
      half_plane({r, r}, {-1, -1}).named("a") & half_plane({-r, r}, {1, -1}).named("b") &
      half_plane({-r, -r}, {1, 1}).named("c") & half_plane({r, -r}, {-1, 1}).named("d");
  const RegionEvaluator region(square);
  const PixelWindow window = unit_window(600);
  const RegionPixels sampled = sample_region(region, window);
  // At 45° the pixels' centres stand in ranks 0.7 pixels apart: 0.04 pixels of the boundary's
  // length.
  EXPECT_NEAR(area(sampled, window), 4, 0.04 * window.pixel_size * 8);
  for (int y = 0; y < 600; ++y)
    for (int x = 0; x < 600; ++x) {
      const int primitive = sampled.primitive[600 * y + x];
      if (primitive < 0) continue;
      const Point point = window.centre(x, y);
      if (std::abs(point[0]) < 0.05 || std::abs(point[1]) < 0.05) continue;
      const int expected = point[0] > 0 ? (point[1] > 0 ? 0 : 3) : (point[1] > 0 ? 1 : 2);
      EXPECT_EQ(primitive, expected);
    }
}

TEST(RegionPixels, SeamsOfAUnionAreNoBoundary) {
  const Region left = box({-1, -1}, {0, 1}).named("left"),
               right = box({0, -1}, {1, 1}).named("right");
  const RegionEvaluator both(left | right);
  for (const int pixels : {300, 301}) {  // pixel centres beside the seam, and on it
    const PixelWindow window = unit_window(pixels);
    const RegionPixels sampled = sample_region(both, window);
    EXPECT_NEAR(area(sampled, window), 4, 0.03);
    EXPECT_NEAR(length(sampled, window, 2), 8, 0.05);
    const int middle = pixels / 2;
    EXPECT_GT(sampled.distance[static_cast<std::size_t>(middle) * pixels + middle], 10);
  }
}

TEST(RegionPixels, ManyHolesAreFoundWithoutLookingAtAll) {
  Region plate = box({-1.2, -1.2}, {1.2, 1.2}).named("plate");
  for (int i = 0; i < 10; ++i)
    for (int j = 0; j < 10; ++j)
      plate = plate - circle({-1.08 + 0.24 * i, -1.08 + 0.24 * j}, 0.05)
                          .named("hole" + std::to_string(10 * i + j));
  const RegionEvaluator region(plate);
  const PixelWindow window = unit_window(800);
  const RegionPixels sampled = sample_region(region, window);
  // Distances are of first order and all holes lie alike on the pixels: 0.02 pixels of the length.
  const double circumferences = 100 * 2 * std::numbers::pi * 0.05;
  EXPECT_NEAR(area(sampled, window), 2.4 * 2.4 - 100 * std::numbers::pi * 0.0025,
              0.02 * window.pixel_size * circumferences);
  const double exact = 4 * 2.4 + circumferences;
  EXPECT_NEAR(length(sampled, window, 1), exact, 0.005 * exact);
}

TEST(RegionPixels, AnUndefinedFunctionIsOutside) {
  // √x − 0.5 has no value for x < 0: inside for x ≥ 1/4.
  const Field function = sqrt(x_coordinate()) - 0.5;
  const RegionEvaluator region(Region({"part", function, function}, 2) &
                               box({-1, -1}, {1, 1}).named("box"));
  const PixelWindow window = unit_window(200);
  EXPECT_NEAR(area(sample_region(region, window), window), 0.75 * 2, 0.02);
}

}  // namespace
}  // namespace rfm
