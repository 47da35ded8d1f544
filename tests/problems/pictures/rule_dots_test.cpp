#include "problems/pictures/rule_dots.hpp"

#include <gtest/gtest.h>

#include "core/primitives.hpp"

namespace rfm {
namespace {

bool is_dark(const Canvas& canvas, double x, double y) {
  return canvas.image().pixel(static_cast<int>(x), static_cast<int>(y)).red < 0.8;
}

DomainRule rule_for(const Region& region, const Grid& grid) {
  QuadratureOptions options;
  options.inside_points = options.cut_points = 2;
  return make_domain_rule(RegionEvaluator(region), grid, options);
}

TEST(RuleDots, StandAtEveryPointOfAPlaneRuleAndNowhereElse) {
  const DomainRule rule =
      rule_for(circle({0, 0}, 1), Grid({2, {-1.2, -1.2}, {1.2, 1.2}}, {4, 4, 1}));
  const PixelWindow window = PixelWindow::around({2, {-1.5, -1.5, 0}, {1.5, 1.5, 0}}, 300, 300);
  Canvas canvas(320, 310);
  paint_rule_dots(canvas, 12, 7, window, rule);
  VolumePoints points = rule.cut_points();
  for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, points);
  int count = 0;
  const auto expect_dot = [&](const Point& point) {
    const PixelPosition at = window.place(point);
    EXPECT_TRUE(is_dark(canvas, 12 + at.x, 7 + at.y)) << point[0] << " " << point[1];
    ++count;
  };
  for (int i = 0; i < points.size(); ++i) expect_dot(points.point(i));
  for (int i = 0; i < rule.boundary().points.size(); ++i)
    expect_dot(rule.boundary().points.point(i));
  int dark = 0;
  for (int y = 0; y < 310; ++y)
    for (int x = 0; x < 320; ++x) dark += is_dark(canvas, x, y);
  // Dots have radii of 3 and 4.2 pixels; some hide others.
  EXPECT_GT(dark, 15 * count);
  EXPECT_LT(dark, 50 * count);
}

TEST(RuleDots, OfABodyAreThoseOfTheSideThatIsSeen) {
  const Region ball = sphere({0, 0, 0}, 1);
  const Box box{3, {-1, -1, -1}, {1, 1, 1}};
  const DomainRule rule = rule_for(ball, Grid(box, {3, 3, 3}));
  const View view = View::at(box, {1, 0, 0});
  const Camera camera = Camera::around(view, ViewWindow::of(view, box), 200, 200);
  const SceneSamples scene = sample_scene(RayCaster(RegionEvaluator(ball), box), camera);
  Canvas canvas(200, 200);
  paint_rule_dots(canvas, 0, 0, scene, camera, rule);
  // The rule is symmetric, but not the picture: it shows dots of x > 0 only.
  int dark = 0;
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) dark += is_dark(canvas, x, y);
  int in_front = 0;
  const SurfacePoints& points = rule.boundary().points;
  for (int i = 0; i < points.size(); ++i) {
    if (points.coordinates[0][i] < 0.5) continue;
    ++in_front;
    const PixelPosition at = camera.place(points.point(i));
    EXPECT_TRUE(is_dark(canvas, at.x, at.y));
  }
  EXPECT_GT(in_front, 10);
  EXPECT_GT(dark, 5 * in_front);

  // Behind a wall nothing is seen.
  const Region wall = half_space({1.5, 0, 0}, {1, 0, 0}) & half_space({1.7, 0, 0}, {-1, 0, 0});
  const Box all{3, {-1, -1.8, -1.8}, {1.8, 1.8, 1.8}};
  const SceneSamples hidden = sample_scene(RayCaster(RegionEvaluator(ball | wall), all), camera);
  Canvas empty(200, 200);
  paint_rule_dots(empty, 0, 0, hidden, camera, rule);
  for (int y = 0; y < 200; ++y)
    for (int x = 0; x < 200; ++x) ASSERT_FALSE(is_dark(empty, x, y));
}

}  // namespace
}  // namespace rfm
