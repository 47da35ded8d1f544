#include "problems/probe_evaluation.hpp"

#include <fmt/format.h>

#include <cmath>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "problems/extremes.hpp"
#include "problems/result_scope.hpp"
#include "problems/set_extremes.hpp"
#include "problems/set_integrals.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

class ProbeEvaluator {
 public:
  ProbeEvaluator(const ScalarProblem& problem, const ScalarSolution& solution)
      : problem_(problem), solution_(solution), scope_(problem.problem().scope) {
    define_results(scope_, solution.results);
  }

  ProbeResult evaluate(const Probe& probe) const {
    try {
      return evaluate_kind(probe);
    } catch (const ComputationError& error) {
      throw ComputationError(fmt::format("probe '{}': {}", probe.name, error.what()));
    }
  }

 private:
  ProbeResult evaluate_kind(const Probe& probe) const {
    switch (probe.kind) {
      case Probe::Kind::point:
        return at_point(probe);
      case Probe::Kind::line:
        return along_line(probe);
      case Probe::Kind::integral:
      case Probe::Kind::average:
        return integrated(probe);
      default:
        return extreme(probe);
    }
  }

  ProbeResult at_point(const Probe& probe) const {
    const Point& point = probe.points[0];
    if (!problem_.region().contains(point, 1e-9 * problem_.bounds().longest_side()))
      throw ProblemFileErrors({Mistake{
          fmt::format("the point of probe '{}' is outside the domain", probe.name), probe.place}});
    ProbeResult result{&probe, values_at(probe, point), {}, {}, {}};
    return result;
  }

  ProbeResult along_line(const Probe& probe) const {
    ProbeResult result{&probe, {}, {}, {}, {}};
    const Point &from = probe.points[0], &to = probe.points[1];
    for (int i = 0; i < probe.point_count; ++i) {
      const double t = probe.point_count == 1 ? 0.0 : double(i) / (probe.point_count - 1);
      Point point{};
      for (int axis = 0; axis < 3; ++axis) point[axis] = from[axis] + t * (to[axis] - from[axis]);
      // A line may leave the domain and come back: points outside have no values.
      if (!problem_.region().contains(point, 1e-9 * problem_.bounds().longest_side())) continue;
      result.line_points.push_back(point);
      result.line_values.push_back(values_at(probe, point));
    }
    return result;
  }

  std::vector<ProbeValue> values_at(const Probe& probe, const Point& point) const {
    std::vector<ProbeValue> values;
    for (const auto& [name, expression] : probe.values) {
      const ExpressionValue meaning = expression.value(scope_);
      ProbeValue value{name, {}, meaning.is_vector};
      for (const Field& component : meaning.components)
        value.components.push_back(value_of(component, point));
      values.push_back(std::move(value));
    }
    return values;
  }

  double value_of(const Field& field, const Point& point) const {
    const int dimension = problem_.problem().dimension;
    const double value = Tape({field}, {0}, dimension).value(point);
    if (std::isfinite(value)) return value;
    throw ComputationError("the value is not a finite number at the point " +
                           point_text(point, dimension) +
                           diagnosis_suffix(field, point, dimension));
  }

  static double finite(double value) {
    if (std::isfinite(value)) return value;
    throw ComputationError("the value is not a finite number");
  }

  // What an integral or extreme is taken of: components along the boundary's normal are added for
  // boundary probes, piece by piece, by `over_pieces`.
  Field scalar(const Probe& probe, const ExpressionScope& scope) const {
    return probe.values[0].second.field(scope);
  }

  // The primitives of a boundary probe, with the scope in which its expression has a normal.
  template <class Visit>
  void over_pieces(const Probe& probe, const Visit& visit) const {
    const auto& primitives = problem_.region().region().primitives();
    const BoundaryTarget& target = *probe.boundary;
    for (int number : problem_.bounding_primitives()) {
      const bool named =
          target.kind == BoundaryTarget::Kind::all ||
          std::ranges::find(target.pieces, primitives[number]->name) != target.pieces.end();
      if (!named) continue;
      const std::vector<Field> normal = outward_normal(number, problem_.region());
      ExpressionScope scope = scope_;
      define_normal(scope, normal);
      define_boundary_results(scope, solution_.results, normal);
      visit(number, scope);
    }
  }

  // Regions chosen by geometry name pieces of which they may hold nothing.
  bool holds_any(const Probe& probe, int primitive) const {
    const std::optional<Field> where = part_of(probe, primitive);
    if (!where || !probe.boundary->chosen_by_geometry) return true;
    const IntegrationPlace place{Contribution::Place::boundary, {primitive}};
    return integrate(step(*where), solution_.rule, place) > 0;
  }

  std::optional<Field> part_of(const Probe& probe, int primitive) const {
    return probe.boundary->where_on(problem_.region().region().primitives()[primitive]->name);
  }

  // The domain, or what it shares with the shape of the probe: a region with a rule of its own, so
  // that the shape's boundary is followed to full order.
  template <class Visit>
  void over_volume(const Probe& probe, const Visit& visit) const {
    if (!probe.region) return visit(problem_.region(), solution_.rule);
    const RegionEvaluator part(problem_.region().region() & *probe.region);
    // As for errors, with more points than for solving: cells are not made for this shape.
    visit(part, problem_.rule(part, solution_.rule.grid(), 2));
  }

  ProbeResult integrated(const Probe& probe) const {
    double integral = 0, measure = 0;
    const DomainRule& rule = solution_.rule;
    if (probe.over == Probe::Over::set) {
      const std::array<double, 2> sums =
          integrated_over_set(scalar(probe, scope_), *probe.set, problem_, solution_.rule.grid());
      integral = sums[0];
      measure = sums[1];
    } else if (probe.over == Probe::Over::boundary) {
      over_pieces(probe, [&](int number, const ExpressionScope& scope) {
        const std::optional<Field> where = part_of(probe, number);
        const Field inside = where ? step(*where) : Field(1.0);
        const IntegrationPlace place{Contribution::Place::boundary, {number}};
        integral += integrate(inside * scalar(probe, scope), rule, place);
        measure += integrate(inside, rule, place);
      });
    } else {
      over_volume(probe, [&](const RegionEvaluator&, const DomainRule& part) {
        integral = integrate(scalar(probe, scope_), part);
        measure = part.measure();
      });
    }
    const bool average = probe.kind == Probe::Kind::average;
    if (average && !(measure > 0))
      throw ComputationError("the set over which it averages has no measure");
    ProbeResult result{&probe, {}, {}, {}, {}};
    result.values.push_back({"", {finite(average ? integral / measure : integral)}, false});
    return result;
  }

  ProbeResult extreme(const Probe& probe) const {
    const double sign = probe.kind == Probe::Kind::max ? 1 : -1;
    Extreme best{-INFINITY, {}};
    const auto offer = [&](const Extreme& other) {
      if (other.value > best.value) best = other;
    };
    if (probe.over == Probe::Over::set) {
      offer(maximum_over_set(sign * scalar(probe, scope_), *probe.set, problem_,
                             solution_.rule.grid()));
    } else if (probe.over == Probe::Over::boundary) {
      over_pieces(probe, [&](int number, const ExpressionScope& scope) {
        if (!holds_any(probe, number)) return;
        offer(maximum_over_boundary(sign * scalar(probe, scope), problem_.region(), solution_.rule,
                                    {number}, part_of(probe, number)));
      });
    } else {
      over_volume(probe, [&](const RegionEvaluator& part, const DomainRule& rule) {
        offer(maximum_over_volume(sign * scalar(probe, scope_), part, rule));
      });
    }
    ProbeResult result{&probe, {}, {}, {}, best.at};
    result.values.push_back({"", {finite(sign * best.value)}, false});
    return result;
  }

  const ScalarProblem& problem_;
  const ScalarSolution& solution_;
  ExpressionScope scope_;
};

}  // namespace

std::vector<ProbeResult> evaluate_probes(const ScalarProblem& problem,
                                         const ScalarSolution& solution) {
  const ProbeEvaluator evaluator(problem, solution);
  std::vector<ProbeResult> results;
  for (const Probe& probe : problem.problem().probes) {
    const bool is_extreme = probe.kind == Probe::Kind::max || probe.kind == Probe::Kind::min;
    for (const Probe& other : problem.problem().probes)
      if (is_extreme && other.name == probe.name + "_at")
        throw ProblemFileErrors(
            {Mistake{fmt::format("the name '{}' is taken by the place of probe '{}'", other.name,
                                 probe.name),
                     other.place}});
    results.push_back(evaluator.evaluate(probe));
  }
  return results;
}

}  // namespace rfm
