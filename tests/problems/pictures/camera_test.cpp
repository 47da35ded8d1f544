#include "problems/pictures/camera.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

using namespace rfm;

namespace {

const Box box{3, {-1, -2, 0}, {3, 2, 5}};

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

TEST(View, HasOrthonormalRightHandedDirections) {
  for (const Point& towards :
       {Point{1, -1.7, 1.1}, Point{0, 0, 2}, Point{0, 0, -1}, Point{-3, 0, 0}}) {
    const View view = View::at(box, towards);
    for (const Point* a : {&view.right, &view.up, &view.towards})
      for (const Point* b : {&view.right, &view.up, &view.towards})
        EXPECT_NEAR(dot(*a, *b), a == b ? 1 : 0, 1e-15);
    EXPECT_NEAR(view.right[1] * view.up[2] - view.right[2] * view.up[1], view.towards[0], 1e-15);
    EXPECT_GT(dot(view.towards, towards), 0);
    EXPECT_GE(view.up[2], 0) << "z is up";
  }
}

TEST(View, WithoutADirectionIsRefused) { EXPECT_THROW(View::at(box, {0, 0, 0}), InvalidArgument); }

TEST(Camera, SendsTheRayOfAPlaceThroughThePointsThatItShowsThere) {
  const View view = View::at(box, {1, -1.7, 1.1});
  const Camera camera = Camera::around(view, ViewWindow::of(view, box), 400, 300);
  for (const PixelPosition& place :
       {PixelPosition{10, 20}, PixelPosition{200, 150}, PixelPosition{390, 295}})
    for (const double distance : {5.0, 20.0, 40.0}) {
      const Line ray = camera.ray(place.x, place.y);
      EXPECT_NEAR(dot(ray.direction, ray.direction), 1, 1e-15);
      const PixelPosition back = camera.place(ray.at(distance));
      EXPECT_NEAR(back.x, place.x, 1e-9);
      EXPECT_NEAR(back.y, place.y, 1e-9);
    }
}

TEST(Camera, ShowsTheWholeBoxAsLargeAsItFits) {
  for (const Point& towards : {Point{1, -1.7, 1.1}, Point{-1, 0.2, -3}}) {
    const View view = View::at(box, towards);
    const Camera camera = Camera::around(view, ViewWindow::of(view, box), 400, 300);
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (int corner = 0; corner < 8; ++corner) {
      const PixelPosition place = camera.place({corner & 1 ? box.high[0] : box.low[0],
                                                corner & 2 ? box.high[1] : box.low[1],
                                                corner & 4 ? box.high[2] : box.low[2]});
      left = std::min(left, place.x);
      right = std::max(right, place.x);
      top = std::min(top, place.y);
      bottom = std::max(bottom, place.y);
    }
    EXPECT_NEAR(left + right, 400, 1e-9);
    EXPECT_NEAR(top + bottom, 300, 1e-9);
    EXPECT_NEAR(std::max((right - left) / 400, (bottom - top) / 300), 1, 1e-9);
  }
}

}  // namespace
