#include "problems/output/canvas.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

double ink(const Canvas& canvas) {
  double sum = 0;
  for (int y = 0; y < canvas.height(); ++y)
    for (int x = 0; x < canvas.width(); ++x) sum += 1 - canvas.image().pixel(x, y).green;
  return sum;
}

// The rectangle of pixels that are not white.
struct Bounds {
  int left = 1 << 20, top = 1 << 20, right = -1, bottom = -1;
};
Bounds ink_bounds(const Canvas& canvas) {
  Bounds bounds;
  for (int y = 0; y < canvas.height(); ++y)
    for (int x = 0; x < canvas.width(); ++x)
      if (canvas.image().pixel(x, y).green < 0.99)
        bounds = {std::min(bounds.left, x), std::min(bounds.top, y), std::max(bounds.right, x + 1),
                  std::max(bounds.bottom, y + 1)};
  return bounds;
}

TEST(Canvas, AFilledPolygonLeavesItsAreaInInk) {
  Canvas canvas(100, 100);
  canvas.fill({{10.3, 20.2}, {80.7, 33.1}, {44.9, 90.6}}, black);
  const double area = 0.5 * std::abs((80.7 - 10.3) * (90.6 - 20.2) - (44.9 - 10.3) * (33.1 - 20.2));
  EXPECT_NEAR(ink(canvas), area, 0.001 * area);
}

TEST(Canvas, HalfOpaqueInkIsHalfAsDark) {
  Canvas canvas(20, 20);
  canvas.fill({{0, 0}, {20, 0}, {20, 20}, {0, 20}}, {1, 0, 0}, 0.5);
  EXPECT_NEAR(canvas.image().pixel(3, 4).red, 1, 1e-9);
  EXPECT_NEAR(canvas.image().pixel(3, 4).blue, 0.5, 0.003);
}

TEST(Canvas, AnArrowEndsAtItsTip) {
  Canvas canvas(120, 60);
  canvas.arrow({10, 30}, {100, 30}, 2, black);
  const Bounds bounds = ink_bounds(canvas);
  EXPECT_NEAR(bounds.left, 9, 1);
  EXPECT_NEAR(bounds.right, 100, 1);
  // Widest behind the tip, 8 long and 6.4 wide.
  EXPECT_NEAR(bounds.bottom - bounds.top, 6.4, 2);
  canvas.arrow({50, 50}, {50, 50}, 2, black);  // of no length: nothing
  EXPECT_EQ(ink_bounds(canvas).bottom, bounds.bottom);
}

TEST(Canvas, TextStandsWhereItIsAligned) {
  for (const bool upwards : {false, true}) {
    Canvas canvas(200, 200);
    canvas.text(
        "HHHH", {100, 100},
        {.size = 20, .horizontal = Align::centre, .vertical = Align::centre, .upwards = upwards});
    const Bounds bounds = ink_bounds(canvas);
    EXPECT_NEAR(0.5 * (bounds.left + bounds.right), 100, 1.5);
    EXPECT_NEAR(0.5 * (bounds.top + bounds.bottom), 100, 1.5);
    const int along = upwards ? bounds.bottom - bounds.top : bounds.right - bounds.left;
    const int across = upwards ? bounds.right - bounds.left : bounds.bottom - bounds.top;
    EXPECT_NEAR(across, 0.73 * 20, 1.5);
    EXPECT_GT(along, 2 * across);
  }
  Canvas canvas(200, 200);
  canvas.text("HHHH", {100, 100}, {.horizontal = Align::before, .vertical = Align::before});
  EXPECT_LE(ink_bounds(canvas).right, 101);
  EXPECT_LE(ink_bounds(canvas).bottom, 101);
  canvas = Canvas(200, 200);
  canvas.text("HHHH", {100, 100}, {.horizontal = Align::after, .vertical = Align::after});
  EXPECT_GE(ink_bounds(canvas).left, 99);
  EXPECT_GE(ink_bounds(canvas).top, 99);
}

TEST(Canvas, EveryTextCanBeDrawn) {
  Canvas canvas(300, 60);
  for (const std::string& text :
       {std::string("θ = ∂u/∂n → ∞"), std::string("bytes \xff\xfe\x80 that are no UTF-8 \xe2\x82"),
        std::string("two\nlines\tand \x01"), std::string(2000, 'W'), std::string(),
        std::string("   "), std::string("$ \\frac{1}{2} $"), std::string("漢字 😀"),
        std::string("a\0b", 3)})
    canvas.text(text, {2, 30});
  EXPECT_GT(ink(canvas), 100);
}

TEST(Canvas, GreekLeavesInk) {
  Canvas canvas(100, 60);
  canvas.text("ω", {50, 30}, {.size = 30});
  EXPECT_GT(ink(canvas), 30);
}

TEST(Canvas, LongTextIsCutToItsWidth) {
  const std::string text = "Wärmeleitung in einer Platte mit Löchern αβγδεζηθικλμνξοπρστυφχψω";
  for (double width = 20; width < 700; width += 37) {
    const std::string cut = fitted(text, 18, width);
    EXPECT_LE(text_extent(cut, 18).width, std::max(width, 1.0 * text_extent("…", 18).width));
  }
  EXPECT_EQ(fitted(text, 18, 5000), text);
  EXPECT_EQ(fitted("", 18, 10), "");
}

TEST(Image, HasAtLeastOnePixel) {
  EXPECT_THROW(Image(0, 5), InvalidArgument);
  EXPECT_THROW(Image(5, -1), InvalidArgument);
}

}  // namespace
}  // namespace rfm
