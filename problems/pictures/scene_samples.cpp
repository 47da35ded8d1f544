#include "problems/pictures/scene_samples.hpp"

#include <tbb/parallel_for.h>

#include <cmath>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

SceneSample sample_at(const RayCaster& rays, const Camera& camera, double x, double y) {
  SceneSample sample;
  if (const auto hit = rays.first_entry(camera.ray(x, y))) {
    sample.point = hit->point;
    sample.normal = hit->normal;
    sample.primitive = hit->primitive;
  }
  return sample;
}

bool needs_block(const SceneSamples& scene, int x, int y) {
  const SceneSample& middle = scene.centre(x, y);
  for (int dy = -1; dy <= 1; ++dy)
    for (int dx = -1; dx <= 1; ++dx) {
      const int u = x + dx, v = y + dy;
      if (u < 0 || v < 0 || u >= scene.width || v >= scene.height) continue;
      if (step_between(middle, scene.centre(u, v), scene.pixel_size) != Step::none) return true;
    }
  return false;
}

}  // namespace

const SceneSample& SceneSamples::fine(int x, int y) const {
  static const SceneSample beyond;
  if (x < 0 || y < 0 || x >= side * width || y >= side * height) return beyond;
  const std::size_t pixel = index(x / side, y / side);
  if (block[pixel] < 0) return centres[pixel];
  return blocks[static_cast<std::size_t>(block[pixel]) * per_block + y % side * side + x % side];
}

Step step_between(const SceneSample& a, const SceneSample& b, double pixel_size) {
  if (a.is_surface() != b.is_surface()) return Step::jump;
  if (!a.is_surface()) return Step::none;
  // Where one surface hides the other, the one is in front of the other's tangential plane and the
  // other behind its. At a crease both are in front, or both behind; on one smooth surface both
  // distances are of second order, however obliquely it is seen.
  constexpr double far_apart = 4, out_of_plane = 0.3, sharp_turn = 0.6;
  const Point d{b.point[0] - a.point[0], b.point[1] - a.point[1], b.point[2] - a.point[2]};
  const double distance = std::hypot(d[0], d[1], d[2]);
  const double b_before_a = dot(a.normal, d), a_before_b = -dot(b.normal, d);
  if (distance > far_apart * pixel_size && b_before_a * a_before_b <= 0 &&
      std::max(std::fabs(b_before_a), std::fabs(a_before_b)) > out_of_plane * distance)
    return Step::jump;
  return a.primitive != b.primitive || dot(a.normal, b.normal) < sharp_turn ? Step::crease
                                                                            : Step::none;
}

SceneSamples sample_scene(const RayCaster& rays, const Camera& camera) {
  SceneSamples scene;
  scene.width = camera.width;
  scene.height = camera.height;
  scene.pixel_size = camera.pixel_size;
  const std::size_t pixels = scene.index(0, scene.height);
  scene.centres.resize(pixels);
  tbb::parallel_for(0, scene.height, [&](int y) {
    for (int x = 0; x < scene.width; ++x)
      scene.centres[scene.index(x, y)] = sample_at(rays, camera, x + 0.5, y + 0.5);
  });
  std::vector<char> wanted(pixels, 0);
  tbb::parallel_for(0, scene.height, [&](int y) {
    for (int x = 0; x < scene.width; ++x) wanted[scene.index(x, y)] = needs_block(scene, x, y);
  });
  scene.block.assign(pixels, -1);
  std::vector<int> refined;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!wanted[i]) continue;
    scene.block[i] = static_cast<int>(refined.size());
    refined.push_back(static_cast<int>(i));
  }
  constexpr int side = SceneSamples::side;
  scene.blocks.resize(refined.size() * SceneSamples::per_block);
  tbb::parallel_for(std::size_t{0}, refined.size(), [&](std::size_t b) {
    const int x = refined[b] % scene.width, y = refined[b] / scene.width;
    for (int i = 0; i < SceneSamples::per_block; ++i)
      scene.blocks[b * SceneSamples::per_block + static_cast<std::size_t>(i)] =
          i == SceneSamples::middle
              ? scene.centres[static_cast<std::size_t>(refined[b])]
              : sample_at(rays, camera, x + (i % side + 0.5) / side, y + (i / side + 0.5) / side);
  });
  return scene;
}

ViewWindow seen_window(const RayCaster& rays, const View& view, const Box& bounds) {
  constexpr int coarse = 120;
  const ViewWindow all = ViewWindow::of(view, bounds);
  const Camera camera = Camera::around(view, all, coarse, coarse);
  std::array<int, 4> seen{coarse, -1, coarse, -1};  // left, right, top, bottom
  for (int y = 0; y < coarse; ++y)
    for (int x = 0; x < coarse; ++x) {
      if (!sample_at(rays, camera, x + 0.5, y + 0.5).is_surface()) continue;
      seen = {std::min(seen[0], x), std::max(seen[1], x), std::min(seen[2], y),
              std::max(seen[3], y)};
    }
  if (seen[1] < 0) return all;
  // Half a pixel may stick out at each side.
  const auto across = [&](double x) { return (x - camera.middle_x) * camera.pixel_size; };
  const auto upwards = [&](double y) { return (camera.middle_y - y) * camera.pixel_size; };
  return {across(seen[0] - 0.5), across(seen[1] + 1.5), upwards(seen[3] + 1.5),
          upwards(seen[2] - 0.5)};
}

}  // namespace rfm
