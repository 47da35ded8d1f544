#include "problems/pictures/convergence_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "problems/output/plot.hpp"

namespace rfm {
namespace {

std::vector<ConvergenceRow> study(double order) {
  std::vector<ConvergenceRow> rows;
  for (const int cells : {8, 16, 32, 64}) {
    SolutionErrors errors;
    errors.l2 = 3 * std::pow(cells, -order);
    errors.h1 = 20 * std::pow(cells, 1 - order);
    rows.push_back({cells, cells * cells, errors, {}});
  }
  return rows;
}

// Centres of the pixels with exactly the colour of a curve, which its line and markers have inside.
std::vector<PixelPosition> ink(const Image& image, const Colour& colour) {
  std::vector<PixelPosition> pixels;
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      const Colour found = image.pixel(x, y);
      if (std::abs(found.red - colour.red) < 0.004 &&
          std::abs(found.green - colour.green) < 0.004 &&
          std::abs(found.blue - colour.blue) < 0.004)
        pixels.push_back({x + 0.5, y + 0.5});
    }
  return pixels;
}

TEST(ConvergencePicture, PowersOfTheCellsAreStraightLinesInProportionToTheirOrders) {
  const Image image = draw_convergence(study(4), "Study", 900).value();
  EXPECT_EQ(image.width(), 900);
  const auto slope = [&](int curve) {
    // The line alone: pixels between the first and the last marker, without text at the right.
    std::vector<PixelPosition> pixels = ink(image, distinct_colour(curve));
    std::erase_if(pixels, [](const PixelPosition& p) { return p.x > 600; });
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (const PixelPosition& p : pixels) {
      sx += p.x;
      sy += p.y;
      sxx += p.x * p.x;
      sxy += p.x * p.y;
    }
    const double n = static_cast<double>(pixels.size());
    return (n * sxy - sx * sy) / (n * sxx - sx * sx);
  };
  EXPECT_GT(slope(0), 0);  // errors fall
  EXPECT_NEAR(slope(0) / slope(1), 4.0 / 3.0, 0.03);
}

TEST(ConvergencePicture, ZeroErrorsAndLonePointsAreNotDrawn) {
  std::vector<ConvergenceRow> rows = study(3);
  for (ConvergenceRow& row : rows) row.errors->l2 = 0;
  const Image image = draw_convergence(rows, "Exact in L2", 600).value();
  EXPECT_TRUE(ink(image, distinct_colour(0)).empty());
  EXPECT_FALSE(ink(image, distinct_colour(1)).empty());
  rows.resize(1);
  EXPECT_FALSE(draw_convergence(rows, "One grid", 600));
  EXPECT_FALSE(draw_convergence({}, "None", 600));
}

TEST(ConvergencePicture, ShowsTheChangeOfUWithoutAnExactSolution) {
  const std::vector<ConvergenceRow> rows = {
      {8, 64, {}, {}}, {16, 256, {}, 1e-3}, {32, 1024, {}, 1e-4}};
  EXPECT_TRUE(draw_convergence(rows, "Change", 600));
}

}  // namespace
}  // namespace rfm
