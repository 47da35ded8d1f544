#include "problems/output/label_places.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace rfm {
namespace {

struct Placed {
  int curve;
  PixelRectangle where;
};

bool overlap(const PixelRectangle& a, const PixelRectangle& b) {
  return a.left < b.right() && b.left < a.right() && a.top < b.bottom() && b.top < a.bottom();
}

TEST(LabelPlaces, NamesHideNeitherCurvesNorEachOtherAndStandNextToTheirs) {
  // Ten circles in a picture with room for all names.
  std::mt19937 random(5);
  std::uniform_int_distribution<int> size(30, 110);
  LabelPlaces places(1000, 500);
  std::vector<std::vector<PixelPosition>> pixels(10);
  for (int c = 0; c < 10; ++c)
    for (double angle = 0; angle < 6.28; angle += 0.01) {
      const int x = static_cast<int>(100 + 200 * (c % 5) + 50 * std::cos(angle)),
                y = static_cast<int>(120 + 250 * (c / 5) + 50 * std::sin(angle));
      places.add_curve_pixel(c, x, y);
      pixels[c].push_back({x + 0.5, y + 0.5});
    }
  std::vector<Placed> placed;
  for (int c = 0; c < 10; ++c) {
    const TextExtent text{size(random), 18};
    const auto place = places.place(c, text);
    ASSERT_TRUE(place) << c;
    placed.push_back({c, {place->x, place->y, double(text.width), double(text.height)}});
  }
  for (const Placed& name : placed) {
    EXPECT_GE(name.where.left, 0);
    EXPECT_LE(name.where.right(), 1000);
    for (const Placed& other : placed)
      if (other.curve != name.curve) {
        EXPECT_FALSE(overlap(name.where, other.where));
      }
    double own = INFINITY, others = INFINITY;  // distances from the name's rectangle
    for (int c = 0; c < 10; ++c)
      for (const PixelPosition& pixel : pixels[c]) {
        const double dx = std::max({name.where.left - pixel.x, pixel.x - name.where.right(), 0.0});
        const double dy = std::max({name.where.top - pixel.y, pixel.y - name.where.bottom(), 0.0});
        double& least = c == name.curve ? own : others;
        least = std::min(least, std::hypot(dx, dy));
      }
    EXPECT_GT(own, 0);
    EXPECT_LT(own, 15);
    EXPECT_GT(others, own);
  }
}

TEST(LabelPlaces, TheMiddleOfASideIsPreferred) {
  LabelPlaces places(400, 200);
  for (int y = 99; y <= 100; ++y)
    for (int x = 50; x < 350; ++x) places.add_curve_pixel(0, x, y);
  EXPECT_NEAR(places.place(0, {60, 20})->x + 30, 200, 5);
}

TEST(LabelPlaces, APlaceIsTakenOnce) {
  // Two curves through the same pixels would both have the best place.
  LabelPlaces places(400, 400);
  for (int y = 100; y < 300; ++y)
    for (const int curve : {0, 1}) places.add_curve_pixel(curve, 200, y);
  const auto first = places.place(0, {60, 20}), second = places.place(1, {60, 20});
  ASSERT_TRUE(first && second);
  EXPECT_FALSE(overlap({first->x, first->y, 60, 20}, {second->x, second->y, 60, 20}));
}

TEST(LabelPlaces, ThereIsNoPlaceWhereThereIsNoRoom) {
  LabelPlaces places(60, 20);
  for (int x = 0; x < 60; ++x) places.add_curve_pixel(0, x, 10);
  EXPECT_FALSE(places.place(0, {50, 16}));
  EXPECT_FALSE(places.place(3, {5, 5}));  // a curve that is not there
}

TEST(LabelPlaces, UnpaintedPlacesArePreferred) {
  LabelPlaces places(400, 400);
  for (int y = 0; y < 400; ++y)
    for (int x = 0; x < 200; ++x) places.add_painted_pixel(x, y);
  for (int y = 50; y < 350; ++y) places.add_curve_pixel(0, 200, y);
  EXPECT_GT(places.place(0, {60, 20})->x, 200);
}

}  // namespace
}  // namespace rfm
