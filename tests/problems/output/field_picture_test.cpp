#include "problems/output/field_picture.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace rfm {
namespace {

constexpr int size = 200;

// u = x² + y² over the disk of radius 1 in [−1.25, 1.25]², sampled by hand.
FieldPicture paraboloid() {
  FieldPicture picture;
  picture.window = PixelWindow::around({2, {-1.25, -1.25, 0}, {1.25, 1.25, 0}}, size, size);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Point p = picture.window.centre(x, y);
      const double r = std::hypot(p[0], p[1]);
      picture.region.distance.push_back(static_cast<float>((1 - r) / picture.window.pixel_size));
      picture.region.primitive.push_back(0);
      picture.value.push_back(r * r);
      picture.slope.push_back(2 * r * picture.window.pixel_size);
    }
  return picture;
}

double difference(const Colour& a, const Colour& b) {
  return std::max(
      {std::abs(a.red - b.red), std::abs(a.green - b.green), std::abs(a.blue - b.blue)});
}

TEST(FieldPicture, ColoursAreThoseOfTheValuesAndTheOutsideIsBackground) {
  const FieldPicture picture = paraboloid();
  const ColourScale scale(ColourMap::uniform, 0, 1);
  Canvas canvas(size + 10, size + 20);
  paint_field(canvas, 3, 7, picture, {scale});
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const double distance = picture.region.distance[y * size + x];
      const Colour colour = canvas.image().pixel(3 + x, 7 + y);
      if (distance > 2) {
        EXPECT_LT(difference(colour, scale(picture.value[y * size + x])), 0.5 / 255 + 1e-9);
      }
      if (distance < -2) {
        EXPECT_EQ(difference(colour, white), 0);
      }
      if (std::abs(distance) < 0.4) {
        EXPECT_LT(lightness(colour), 0.01);
      }
    }
  EXPECT_EQ(difference(canvas.image().pixel(0, 0), white), 0);
}

TEST(FieldPicture, ContoursPassWhereTheFieldHasTheirLevelAndNowhereElse) {
  const FieldPicture picture = paraboloid();
  const ColourScale scale(ColourMap::uniform, 0, 1);
  Canvas plain(size, size), lined(size, size);
  FieldStyle style{scale};
  paint_field(plain, 0, 0, picture, style);
  style.level_step = 0.25;
  style.line_width = 1;
  paint_field(lined, 0, 0, picture, style);
  double ink = 0;
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x) {
      const Colour before = plain.image().pixel(x, y), after = lined.image().pixel(x, y);
      const double brightest = std::max({before.red, before.green, before.blue});
      const double amount = brightest > 0 ? difference(before, after) / brightest : 0;
      ink += amount;
      const Point p = picture.window.centre(x, y);
      double nearest = INFINITY;  // in pixels
      for (const double level : {0.25, 0.5, 0.75})
        nearest = std::min(nearest, std::abs(std::hypot(p[0], p[1]) - std::sqrt(level)) /
                                        picture.window.pixel_size);
      if (picture.region.distance[y * size + x] < 2) continue;
      if (nearest > 1.2) {
        EXPECT_EQ(amount, 0);
      }
      if (nearest < 0.2) {
        EXPECT_GT(amount, 0.4);
      }
    }
  // Lines of one pixel, 65 % dark, along circles of radius 1/2, √½ and √¾.
  const double pixels =
      2 * M_PI * (0.5 + std::sqrt(0.5) + std::sqrt(0.75)) / picture.window.pixel_size;
  EXPECT_NEAR(ink, 0.65 * pixels, 0.03 * pixels);
}

TEST(FieldPicture, AFieldThatIsLevelHasNoContours) {
  FieldPicture picture = paraboloid();
  std::ranges::fill(picture.value, 0.5);
  std::ranges::fill(picture.slope, 1e-17);
  const ColourScale scale(ColourMap::uniform, 0, 1);
  Canvas canvas(size, size);
  FieldStyle style{scale};
  style.level_step = 0.25;
  paint_field(canvas, 0, 0, picture, style);
  EXPECT_LT(difference(canvas.image().pixel(100, 100), scale(0.5)), 0.01);
}

TEST(FieldPicture, PartsAreOutlinedInsideOnly) {
  FieldPicture picture = paraboloid();
  RegionPixels half = picture.region;  // {x ≤ 0}, as a part
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      half.distance[y * size + x] =
          static_cast<float>(-picture.window.centre(x, y)[0] / picture.window.pixel_size);
  picture.parts.push_back(half);
  const ColourScale scale(ColourMap::uniform, 0, 1);
  Canvas canvas(size, size);
  paint_field(canvas, 0, 0, picture, {scale});
  for (int y = 0; y < size; ++y) {
    const double distance = picture.region.distance[y * size + size / 2];
    const Colour colour = canvas.image().pixel(size / 2, y);
    const Colour unlined = scale(picture.value[y * size + size / 2]);
    if (distance > 3) {
      EXPECT_LT(lightness(colour), 0.9 * lightness(unlined));
      EXPECT_LT(difference(canvas.image().pixel(size / 2 + 5, y),
                           scale(picture.value[y * size + size / 2 + 5])),
                0.01);
    }
    if (distance < -3) {
      EXPECT_EQ(difference(colour, white), 0);
    }
  }
}

TEST(FieldPicture, WhatHasNoValueIsGrey) {
  FieldPicture picture = paraboloid();
  picture.value[100 * size + 100] = NAN;
  Canvas canvas(size, size);
  FieldStyle style{ColourScale(ColourMap::uniform, 0, 1)};
  style.level_step = 0.25;
  paint_field(canvas, 0, 0, picture, style);
  EXPECT_LT(difference(canvas.image().pixel(100, 100), {0.5, 0.5, 0.5}), 0.01);
}

TEST(FieldPicture, ArrowsPointAlongTheFieldAndStayInside) {
  FieldPicture picture = paraboloid();
  picture.slope.clear();
  std::ranges::fill(picture.value, 1.0);
  picture.vector_x.assign(picture.value.size(), 0.0);
  picture.vector_y.assign(picture.value.size(), 1.0);  // upwards
  const ColourScale scale(ColourMap::uniform, 0, 1);
  Canvas plain(size, size), canvas(size, size);
  FieldStyle style{scale};
  style.arrow_spacing = 30;
  paint_field(canvas, 0, 0, picture, style);
  FieldPicture still = picture;
  std::ranges::fill(still.vector_y, 0.0);
  paint_field(plain, 0, 0, still, style);
  // The heads are above: in each arrow more ink stands in the upper than in the lower half.
  const int step = 30, first = (size % step + step) / 2;
  int arrows = 0;
  for (int y = first; y < size; y += step)
    for (int x = first; x < size; x += step) {
      double above = 0, below = 0;
      for (int dy = -14; dy <= 14; ++dy)
        for (int dx = -6; dx <= 6; ++dx) {
          if (x + dx >= size || y + dy >= size) continue;
          const double ink =
              difference(canvas.image().pixel(x + dx, y + dy), plain.image().pixel(x + dx, y + dy));
          (dy < 0 ? above : below) += ink;
        }
      if (above + below == 0) continue;
      ++arrows;
      EXPECT_GT(above, 1.1 * below);
    }
  EXPECT_GT(arrows, 8);
  for (int y = 0; y < size; ++y)
    for (int x = 0; x < size; ++x)
      if (picture.region.distance[y * size + x] < -3) {
        EXPECT_EQ(difference(canvas.image().pixel(x, y), white), 0);
      }
}

}  // namespace
}  // namespace rfm
