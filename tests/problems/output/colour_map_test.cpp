#include "problems/output/colour_map.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

void expect_colour(const Colour& colour, int red, int green, int blue, double tolerance = 1e-12) {
  EXPECT_NEAR(colour.red * 255, red, tolerance);
  EXPECT_NEAR(colour.green * 255, green, tolerance);
  EXPECT_NEAR(colour.blue * 255, blue, tolerance);
}

TEST(ColourMap, LightnessIsThatOfOklab) {
  // B. Ottosson (2020): white has L = 1, black 0, pure sRGB red 0.6279554.
  EXPECT_NEAR(lightness(white), 1, 1e-7);
  EXPECT_EQ(lightness(black), 0);
  EXPECT_NEAR(lightness({1, 0, 0}), 0.6279554, 1e-6);
}

TEST(ColourMap, UniformEndsInTheColoursOfViridis) {
  expect_colour(colour_at(ColourMap::uniform, 0), 0x44, 0x01, 0x54);
  expect_colour(colour_at(ColourMap::uniform, 1), 0xFD, 0xE7, 0x25);
  expect_colour(colour_at(ColourMap::uniform, -3), 0x44, 0x01, 0x54);
  expect_colour(colour_at(ColourMap::uniform, 7), 0xFD, 0xE7, 0x25);
  // The published table of 256 colours (matplotlib, _cm_listed.py): entry 128 is
  // (0.127568, 0.566949, 0.550556).
  const Colour middle = colour_at(ColourMap::uniform, 128 / 255.0);
  EXPECT_NEAR(middle.red, 0.127568, 0.01);
  EXPECT_NEAR(middle.green, 0.566949, 0.01);
  EXPECT_NEAR(middle.blue, 0.550556, 0.01);
}

TEST(ColourMap, LightnessOfUniformGrowsSteadily) {
  const int steps = 200;
  const double mean =
      (lightness(colour_at(ColourMap::uniform, 1)) - lightness(colour_at(ColourMap::uniform, 0))) /
      steps;
  for (int i = 0; i < steps; ++i) {
    const double step = lightness(colour_at(ColourMap::uniform, (i + 1.0) / steps)) -
                        lightness(colour_at(ColourMap::uniform, double(i) / steps));
    EXPECT_GT(step, 0.8 * mean) << i;
    EXPECT_LT(step, 1.25 * mean) << i;
  }
}

TEST(ColourMap, DivergingIsNeutralAndLightestInTheMiddleAndSymmetricInLightness) {
  const Colour middle = colour_at(ColourMap::diverging, 0.5);
  EXPECT_EQ(middle.red, middle.green);
  EXPECT_EQ(middle.green, middle.blue);
  for (double t = 0; t < 0.5; t += 0.01) {
    const double low = lightness(colour_at(ColourMap::diverging, t)),
                 high = lightness(colour_at(ColourMap::diverging, 1 - t));
    EXPECT_NEAR(low, high, 0.01) << t;
    EXPECT_LT(low, lightness(colour_at(ColourMap::diverging, t + 0.01)));
    EXPECT_GT(colour_at(ColourMap::diverging, t).blue, colour_at(ColourMap::diverging, t).red);
    EXPECT_LT(colour_at(ColourMap::diverging, 1 - t).blue,
              colour_at(ColourMap::diverging, 1 - t).red);
  }
}

TEST(ColourScale, FollowsItsMapAndClampsBeyondIt) {
  const ColourScale scale(ColourMap::uniform, -2, 6);
  for (double t = 0; t <= 1; t += 0.037) {
    const Colour expected = colour_at(ColourMap::uniform, t), found = scale(-2 + 8 * t);
    EXPECT_NEAR(found.red, expected.red, 0.2 / 255);
    EXPECT_NEAR(found.green, expected.green, 0.2 / 255);
    EXPECT_NEAR(found.blue, expected.blue, 0.2 / 255);
  }
  expect_colour(scale(-100), 0x44, 0x01, 0x54);
  expect_colour(scale(INFINITY), 0xFD, 0xE7, 0x25);
  expect_colour(scale(NAN), 128, 128, 128, 1);
}

TEST(ColourScale, WidensAnEmptyRangeAndRefusesAnImpossibleOne) {
  const ColourScale constant(ColourMap::uniform, 3, 3);
  EXPECT_LT(constant.low(), 3);
  EXPECT_GT(constant.high(), 3);
  const ColourScale zero(ColourMap::uniform, 0, 0);
  EXPECT_LT(zero.low(), zero.high());
  EXPECT_THROW(ColourScale(ColourMap::uniform, 1, 0), InvalidArgument);
  EXPECT_THROW(ColourScale(ColourMap::uniform, 0, INFINITY), InvalidArgument);
  EXPECT_THROW(ColourScale(ColourMap::uniform, NAN, 1), InvalidArgument);
}

TEST(ColourScale, ZeroIsTheNeutralColourOfASymmetricRange) {
  const ValueRange range = symmetric_about_zero({-0.3, 1.7});
  EXPECT_EQ(range.low, -1.7);
  EXPECT_EQ(range.high, 1.7);
  expect_colour(ColourScale(ColourMap::diverging, range.low, range.high)(0), 0xF2, 0xF2, 0xF2);
}

}  // namespace
}  // namespace rfm
