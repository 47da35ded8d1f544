#include "problems/structure_check.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// With random functions in the place of the Ψ, of the size of the domain.
StructureTrials random_trials(const DomainRule& rule) {
  const Box& box = rule.grid().box();
  return {.dimension = rule.dimension(),
          .count = 2,
          .centre = box.center(),
          .size = 0.5 * box.longest_side()};
}

// With nothing there: what is missed of small data would be rounding beside random functions.
StructureTrials trial_of_data(const DomainRule& rule) {
  StructureTrials trials = random_trials(rule);
  trials.count = 1;
  trials.amplitude = 0;
  return trials;
}

// The largest |f| of some fields at points where they are numbers.
double size_of(const std::vector<Field>& fields, const std::vector<Point>& points, int dimension) {
  const Tape tape(fields, {0}, dimension);
  double largest = 0;
  for (const Point& point : points)
    for (std::size_t i = 0; i < fields.size(); ++i)
      if (const double value = std::fabs(tape.value(point, static_cast<int>(i)));
          std::isfinite(value))
        largest = std::max(largest, value);
  return largest;
}

// What is missed of a condition, by the size of what it is made of.
class Misses {
 public:
  Misses(const std::vector<Structure>& structures, std::size_t unknown, const DomainRule& rule,
         const std::vector<Point>& points)
      : structures_(structures), unknown_(unknown), rule_(rule), points_(points) {
    places_ = points_inside(rule);
  }

  // By the size of the value, and of how far u is from it inside.
  StructureDeviation of_value(const Field& value) {
    places_.insert(places_.end(), points_.begin(), points_.end());
    const auto difference = [&](const Field& u) { return std::vector<Field>{u - value, value}; };
    return worst([&](const std::vector<Field>& u) { return u[unknown_]; }, value, difference, 0);
  }

  // By the size of the gradient, inside and at the boundary, and of the data.
  StructureDeviation of_derivative(const BoundaryOperator& residual) {
    const double data =
        size_of({residual(std::vector<Field>(structures_.size(), 0.0))}, points_, dimension());
    places_.insert(places_.end(), points_.begin(), points_.end());
    // Rounding of a constant u is no slope.
    const double slight = 1e-3 / rule_.grid().box().longest_side();
    const auto slopes = [&](const Field& u) {
      std::vector<Field> fields{slight * u};
      for (int axis = 0; axis < dimension(); ++axis) fields.push_back(partial(u, axis));
      return fields;
    };
    return worst(residual, 0.0, slopes, data);
  }

 private:
  int dimension() const { return rule_.dimension(); }

  template <class Parts>
  StructureDeviation worst(const BoundaryOperator& condition, const Field& data, Parts&& parts,
                           double scale) const {
    StructureDeviation found;
    for (const StructureTrials& trials : {random_trials(rule_), trial_of_data(rule_)}) {
      found = largest_deviation(structures_, condition, data, points_, trials);
      found.scale = scale;
      for (int trial = 0; trial < trials.count; ++trial) {
        const Field u = random_solution(structures_, trials, trial)[unknown_];
        found.scale = std::max(found.scale, size_of(parts(u), places_, dimension()));
      }
      if (trials.amplitude == 0) found.trial = StructureDeviation::of_data;
      if (!is_met(found)) break;
    }
    return found;
  }

  const std::vector<Structure>& structures_;
  std::size_t unknown_;
  const DomainRule& rule_;
  const std::vector<Point>& points_;
  std::vector<Point> places_;  // where parts are looked at
};

Field along(const std::vector<Field>& direction, const Field& f) {
  Field sum = 0.0;
  for (std::size_t axis = 0; axis < direction.size(); ++axis)
    sum = sum + direction[axis] * partial(f, static_cast<int>(axis));
  return sum;
}

}  // namespace

bool is_met(const std::optional<StructureDeviation>& deviation) {
  return !deviation || deviation->largest <= rounding * deviation->scale;
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
  const auto misses = [&] { return Misses(structures, unknown, rule, points); };
  if (condition.kind != Condition::Kind::value)
    return misses().of_derivative([&](const std::vector<Field>& u) {
      return natural_residual(condition, coefficients, normal, u[unknown]) /
             normal_conductivity(coefficients, normal);
    });
  const StructureDeviation worst = misses().of_value(condition.data[0]);
  if (!condition.clamped || !is_met(worst)) return worst;
  return misses().of_derivative(
      [&](const std::vector<Field>& u) { return along(normal, u[unknown]); });
}

std::optional<StructureDeviation> deviation_from(const ThinSet& set, int unknown,
                                                 const Field& value,
                                                 const std::vector<Structure>& structures,
                                                 const DomainRule& rule) {
  const std::vector<Point> points = points_of(set, rule);
  if (points.empty()) return std::nullopt;
  return Misses(structures, static_cast<std::size_t>(unknown), rule, points).of_value(value);
}

bool reaches(const ThinSet& set, const DomainRule& rule) {
  const Tape distance({set.function}, {0}, rule.dimension());
  const double near = 2 * cell_side(rule.grid());
  const auto any = [&](const VolumePoints& points) {
    for (int i = 0; i < points.size(); ++i)
      if (distance.value(points.point(i)) <= near) return true;
    return false;
  };
  if (any(rule.cut_points())) return true;
  return std::ranges::any_of(rule.inside_cells(), [&](int cell) {
    VolumePoints inside;
    rule.add_inside_points(cell, inside);
    return any(inside);
  });
}

std::string deviation_text(const StructureDeviation& deviation, int dimension) {
  return fmt::format(
      "it is {:.3g} off at ({:.4g}, {:.4g}{}) for {}", deviation.largest, deviation.place[0],
      deviation.place[1], dimension > 2 ? fmt::format(", {:.4g}", deviation.place[2]) : "",
      deviation.trial == StructureDeviation::of_data ? "psi = 0" : "an arbitrary psi");
}

}  // namespace rfm
