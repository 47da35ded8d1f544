#include "problems/structure_check.hpp"

#include <fmt/format.h>

#include "core/boundary_piece.hpp"
#include "core/tape.hpp"
#include "problems/scalar_forms.hpp"
#include "problems/structure_language.hpp"

namespace rfm {
namespace {

constexpr double rounding = 1e-6;

// The points of a rule that a condition is about.
std::vector<Point> points_of(const PieceCondition& condition, const DomainRule& rule) {
  const Tape where({condition.where.value_or(1.0)}, {0}, rule.dimension());
  const SurfacePoints& all = rule.boundary().points;
  std::vector<Point> points;
  for (int i = 0; i < all.size(); ++i)
    if (all.numbers[i] == condition.primitive && where.value(all.point(i)) >= 0)
      points.push_back(all.point(i));
  return points;
}

// Points of a set: from those of a rule that are near by Newton's method, or its own.
std::vector<Point> points_of(const ThinSet& set, const DomainRule& rule) {
  if (!set.surface) return set.points.size() == 1 ? set.points : std::vector<Point>{};
  constexpr std::size_t most = 200;
  const int dimension = rule.dimension();
  const Tape surface({*set.surface, set.where, set.function}, {1, 0, 0}, dimension);
  const double size = rule.grid().box().longest_side(), cell = cell_side(rule.grid());
  std::vector<Point> points;
  const auto add_near = [&](Point at) {
    if (points.size() == most || surface.value(at, 2) > cell) return;
    for (int step = 0; step < 6; ++step) {
      Point gradient{};
      const double value = surface.value_and_gradient(at, gradient, 0);
      double square = 0;
      for (int axis = 0; axis < dimension; ++axis) square += gradient[axis] * gradient[axis];
      for (int axis = 0; axis < dimension; ++axis) at[axis] -= value * gradient[axis] / square;
    }
    // Near its ends a set is not regular.
    if (surface.value(at, 2) < 1e-12 * size && surface.value(at, 1) > 1e-3 * size)
      points.push_back(at);
  };
  for (int i = 0; i < rule.cut_points().size(); ++i) add_near(rule.cut_points().point(i));
  for (const int cell_number : rule.inside_cells()) {
    VolumePoints inside;
    rule.add_inside_points(cell_number, inside);
    for (int i = 0; i < inside.size(); ++i) add_near(inside.point(i));
  }
  return points;
}

// Some points inside, where a structure with arbitrary functions has some value.
std::vector<Point> points_inside(const DomainRule& rule) {
  constexpr std::size_t enough = 50;
  std::vector<Point> points;
  const auto add = [&](const VolumePoints& some) {
    for (int i = 0; i < some.size() && points.size() < enough; ++i) points.push_back(some.point(i));
  };
  const std::vector<int>& cells = rule.inside_cells();
  const std::size_t step = cells.size() / enough + 1;
  for (std::size_t i = 0; i < cells.size(); i += step) {
    VolumePoints inside;
    rule.add_inside_points(cells[i], inside);
    add(inside);
  }
  if (points.empty()) add(rule.cut_points());
  return points;
}

// The largest |u − value| at `points`, and inside: units of length make it large or small.
StructureDeviation deviation_of_value(const std::vector<Structure>& structures, int unknown,
                                      const Field& value, const std::vector<Point>& points,
                                      const DomainRule& rule) {
  const auto largest = [&](const std::vector<Point>& places) {
    return largest_deviation(
        structures,
        [&](const std::vector<Field>& u) { return u[static_cast<std::size_t>(unknown)]; }, value,
        places, {.dimension = rule.dimension(), .count = 2});
  };
  StructureDeviation found = largest(points);
  const std::vector<Point> inside = points_inside(rule);
  if (const double scale = inside.empty() ? 0 : largest(inside).largest; scale > 0)
    found.scale = scale;
  return found;
}

Field along(const std::vector<Field>& direction, const Field& f) {
  Field sum = 0.0;
  for (std::size_t axis = 0; axis < direction.size(); ++axis)
    sum = sum + direction[axis] * partial(f, static_cast<int>(axis));
  return sum;
}

}  // namespace

bool is_met(const std::optional<StructureDeviation>& deviation) {
  return !deviation || deviation->largest < rounding * deviation->scale;
}

std::optional<StructureDeviation> deviation_from(const PieceCondition& condition,
                                                 const std::vector<Structure>& structures,
                                                 const ScalarCoefficients& coefficients,
                                                 const DomainRule& rule,
                                                 const RegionEvaluator& region) {
  const std::vector<Point> points = points_of(condition, rule);
  if (points.empty()) return std::nullopt;
  const std::vector<Field> normal = outward_normal(condition.primitive, region);
  const auto unknown = static_cast<std::size_t>(condition.component);
  const auto largest = [&](const BoundaryOperator& condition_on, const Field& data) {
    return largest_deviation(structures, condition_on, data, points,
                             {.dimension = rule.dimension(), .count = 2});
  };
  if (condition.kind != Condition::Kind::value)
    return largest(
        [&](const std::vector<Field>& u) {
          return natural_residual(condition, coefficients, normal, u[unknown]) /
                 normal_conductivity(coefficients, normal);
        },
        0.0);
  const StructureDeviation worst =
      deviation_of_value(structures, condition.component, condition.data[0], points, rule);
  if (!condition.clamped || !is_met(worst)) return worst;
  return largest([&](const std::vector<Field>& u) { return along(normal, u[unknown]); }, 0.0);
}

std::optional<StructureDeviation> deviation_from(const ThinSet& set, int unknown,
                                                 const Field& value,
                                                 const std::vector<Structure>& structures,
                                                 const DomainRule& rule) {
  const std::vector<Point> points = points_of(set, rule);
  if (points.empty()) return std::nullopt;
  return deviation_of_value(structures, unknown, value, points, rule);
}

std::string deviation_text(const StructureDeviation& deviation, int dimension) {
  return fmt::format("it is {:.3g} off at ({:.4g}, {:.4g}{}) for an arbitrary psi",
                     deviation.largest, deviation.place[0], deviation.place[1],
                     dimension > 2 ? fmt::format(", {:.4g}", deviation.place[2]) : "");
}

}  // namespace rfm
