#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/primitives.hpp"
#include "problems/pictures/scene_painter.hpp"
#include "problems/pictures/scene_panel.hpp"
#include "problems/pictures/scene_values.hpp"

using namespace rfm;

namespace {

constexpr double pi = 3.14159265358979323846;
const Box cube{3, {-1, -1, -1}, {1, 1, 1}};
const Point towards{1, -1.7, 1.1};

ScenePanel panel_of(const Region& region, const std::optional<CutPlane>& cut = {}) {
  ScenePanel panel(region, cube, cut, View::at(cube, towards));
  panel.sample(ViewWindow::of(panel.view(), cube), 160, 120);
  return panel;
}

TEST(Scene, ShowsABallAsADiskOfTheSizeThatPerspectiveGives) {
  // Seen from distance d the silhouette of the unit ball is a circle of radius d / √(d² − 1) in the
  // plane through its centre.
  ScenePanel panel = panel_of(sphere({0, 0, 0}, 1));
  double covered = 0;
  const SceneSamples& scene = panel.samples();
  for (int y = 0; y < 3 * scene.height; ++y)
    for (int x = 0; x < 3 * scene.width; ++x) covered += scene.fine(x, y).is_surface() / 9.0;
  const double d = panel.view().distance, radius = d / std::sqrt(d * d - 1) / scene.pixel_size;
  EXPECT_NEAR(covered, pi * radius * radius, 0.002 * pi * radius * radius);
}

TEST(Scene, HasMoreRaysAtTheSilhouetteOnly) {
  const ScenePanel panel = panel_of(sphere({0, 0, 0}, 1));
  const SceneSamples& scene = panel.samples();
  const double radius = 1 / scene.pixel_size;
  const double refined = static_cast<double>(scene.blocks.size()) / SceneSamples::per_block;
  EXPECT_GT(refined, 2 * pi * radius);
  EXPECT_LT(refined, 4 * 2 * pi * radius);
}

TEST(Scene, EvaluatesAFieldWhereRaysMeetTheSurface) {
  ScenePanel panel = panel_of(sphere({0, 0, 0}, 1));
  const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();
  const ValueRange range = evaluate_on(panel.samples(), {x + 2 * y - z}, cube);
  for (const SceneSample& sample : panel.samples().centres)
    if (sample.is_surface()) {
      EXPECT_NEAR(std::hypot(sample.point[0], sample.point[1], sample.point[2]), 1, 1e-13);
      EXPECT_NEAR(sample.value, sample.point[0] + 2 * sample.point[1] - sample.point[2], 1e-13);
      EXPECT_LE(range.low, sample.value);
      EXPECT_GE(range.high, sample.value);
    }
}

TEST(Scene, OfAVectorShowsItsLength) {
  ScenePanel panel = panel_of(sphere({0, 0, 0}, 1));
  const ValueRange range =
      evaluate_on(panel.samples(), {x_coordinate(), y_coordinate(), z_coordinate()}, cube);
  EXPECT_NEAR(range.low, 1, 1e-13);
  EXPECT_NEAR(range.high, 1, 1e-13);
}

TEST(Scene, CutsAwayWhatTheNormalPointsTo) {
  const CutPlane cut{{0, 0.25, 0}, {0, -1, 0}};
  const ScenePanel panel = panel_of(sphere({0, 0, 0}, 1), cut);
  int on_cut = 0;
  for (const SceneSample& sample : panel.samples().centres) {
    if (!sample.is_surface()) continue;
    EXPECT_GE(sample.point[1], 0.25 - 1e-14);
    on_cut += sample.primitive == panel.cut_primitive();
  }
  EXPECT_GT(on_cut, 100);
}

TEST(CutPlane, FacesTheViewerAndSaysWhereItIs) {
  const CutPlane cut = CutPlane::facing({3, {0, 0, 0}, {2, 3, 4}}, towards);
  EXPECT_EQ(cut.point, (Point{1, 1.5, 2}));
  EXPECT_EQ(cut.normal, (Point{0, -1, 0}));
  EXPECT_EQ(cut.equation(), "y = 1.5");
  EXPECT_EQ((CutPlane{{1, 1, 0}, {1, -2, 0}}.equation()), "x - 2 y = -1");
}

TEST(CutPlane, WithoutADirectionIsRefused) {
  EXPECT_THROW(panel_of(sphere({0, 0, 0}, 1), CutPlane{{0, 0, 0}, {0, 0, 0}}), InvalidArgument);
}

TEST(Steps, TellCreasesFromJumps) {
  const auto sample = [](const Point& point, const Point& normal, int primitive) {
    SceneSample s;
    s.point = point;
    s.normal = normal;
    s.primitive = primitive;
    return s;
  };
  const SceneSample here = sample({0, 0, 0}, {0, 0, 1}, 0), nothing;
  EXPECT_EQ(step_between(here, nothing, 0.01), Step::jump);
  EXPECT_EQ(step_between(nothing, nothing, 0.01), Step::none);
  EXPECT_EQ(step_between(here, sample({0.01, 0, 0}, {0, 0, 1}, 0), 0.01), Step::none);
  EXPECT_EQ(step_between(here, sample({0.01, 0, 0}, {0, 0, 1}, 1), 0.01), Step::crease);
  EXPECT_EQ(step_between(here, sample({0.01, 0, 0}, {1, 0, 0}, 0), 0.01), Step::crease);
  // The same primitive far behind, and a steep wall that goes down from here.
  EXPECT_EQ(step_between(here, sample({0.01, 0, -1}, {0, 0, 1}, 0), 0.01), Step::jump);
  EXPECT_EQ(step_between(here, sample({0.01, 0, -1}, {1, 0, 0}, 1), 0.01), Step::crease);
}

TEST(ScenePainter, LeavesCutFacesInTheColourOfTheScaleAndShadesTheRest) {
  const ScenePanel panel = panel_of(sphere({0, 0, 0}, 1), CutPlane{{0, 0, 0}, {0, -1, 0}});
  SceneStyle style;
  const Colour colour{0.2, 0.6, 0.4};
  style.colour = [&](const SceneSample&) { return colour; };
  style.flat_primitive = panel.cut_primitive();
  Canvas canvas(160, 120);
  paint_scene(canvas, 0, 0, panel.samples(), panel.camera(), style);
  const SceneSamples& scene = panel.samples();
  int flat = 0, shaded = 0;
  for (int y = 0; y < 120; ++y)
    for (int x = 0; x < 160; ++x) {
      if (scene.block[scene.index(x, y)] >= 0) continue;
      const SceneSample& sample = scene.centre(x, y);
      const Colour pixel = canvas.image().pixel(x, y);
      if (!sample.is_surface()) {
        EXPECT_EQ(pixel.green, 1);
      } else if (sample.primitive == panel.cut_primitive()) {
        EXPECT_NEAR(pixel.green, 0.6, 0.003);
        ++flat;
      } else {
        shaded += std::fabs(pixel.green - 0.6) > 0.01;
      }
    }
  EXPECT_GT(flat, 500);
  EXPECT_GT(shaded, 100);
}

}  // namespace
