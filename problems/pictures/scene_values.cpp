#include "problems/pictures/scene_values.hpp"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>

#include "core/tape.hpp"

namespace rfm {
namespace {

Point within(const Box& bounds, Point point) {
  for (int axis = 0; axis < 3; ++axis)
    point[axis] = std::clamp(point[axis], bounds.low[axis], bounds.high[axis]);
  return point;
}

Field length_of(const std::vector<Field>& components) {
  Field square = 0.0;
  for (const Field& component : components) square = square + component * component;
  return sqrt(square);
}

}  // namespace

ValueRange evaluate_on(SceneSamples& scene, const std::vector<Field>& components,
                       const Box& bounds) {
  const Tape tape({components.size() > 1 ? length_of(components) : components[0]}, {0}, 3);
  std::vector<SceneSample*> shown;
  for (auto* samples : {&scene.centres, &scene.blocks})
    for (SceneSample& sample : *samples)
      if (sample.is_surface()) shown.push_back(&sample);
  constexpr int block = Tape::block_size;
  const int count = static_cast<int>(shown.size());
  const double step_inside = 1e-6 * bounds.longest_side();
  tbb::parallel_for(tbb::blocked_range<int>(0, (count + block - 1) / block), [&](const auto& part) {
    Tape::Workspace workspace(tape);
    std::array<std::array<double, block>, 3> coordinates;
    for (int b = part.begin(); b < part.end(); ++b) {
      const int begin = b * block, size = std::min(block, count - begin);
      for (int i = 0; i < size; ++i) {
        const Point point = within(bounds, shown[begin + i]->point);
        for (int axis = 0; axis < 3; ++axis) coordinates[axis][i] = point[axis];
      }
      tape.evaluate({{coordinates[0].data(), coordinates[1].data(), coordinates[2].data()}, size},
                    workspace);
      for (int i = 0; i < size; ++i) {
        SceneSample& sample = *shown[begin + i];
        sample.value = workspace.coefficient(0)[i];
        if (std::isfinite(sample.value)) continue;
        Point inside = sample.point;
        for (int axis = 0; axis < 3; ++axis) inside[axis] -= step_inside * sample.normal[axis];
        sample.value = tape.value(within(bounds, inside));
      }
    }
  });
  ValueRange range{INFINITY, -INFINITY};
  for (const SceneSample* sample : shown)
    if (std::isfinite(sample->value))
      range = {std::min(range.low, sample->value), std::max(range.high, sample->value)};
  return range;
}

}  // namespace rfm
