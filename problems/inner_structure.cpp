#include "problems/inner_structure.hpp"

#include "core/function_shaping.hpp"
#include "core/tape.hpp"
#include "problems/structure_language.hpp"
#include "solution_structures/condition_part.hpp"

namespace rfm {
namespace {

// Whether points of the rule near a set lie on both sides of its surface.
bool has_both_sides(const ThinSet& set, const DomainRule& rule) {
  const Tape tape({*set.surface, set.function}, {0, 0}, rule.dimension());
  const double reach = 2 * cell_side(rule.grid());
  bool above = false, below = false;
  const auto look = [&](const VolumePoints& points) {
    for (int i = 0; i < points.size(); ++i) {
      const Point at = points.point(i);
      if (tape.value(at, 1) > reach) continue;
      (tape.value(at, 0) > 0 ? above : below) = true;
    }
  };
  look(rule.cut_points());
  for (const int cell : rule.inside_cells()) {
    VolumePoints points;
    rule.add_inside_points(cell, points);
    look(points);
  }
  return above && below;
}

}  // namespace

Structure with_inner_conditions(DirichletPlan& plan, int component, const StructureOptions& options,
                                const DomainRule& rule, const Box& bounds, int& functions) {
  const double length = bounds.longest_side();
  const Field boundary = plan.weight.function;  // 1 where nothing is prescribed by structure
  std::vector<const SetValue*> sets;
  for (const SetValue& value : options.values)
    if (value.component == component) sets.push_back(&value);
  std::vector<ConditionPart> parts;
  if (!plan.by_structure.empty()) parts.push_back({plan.given, plan.distance, 1});
  for (const SetValue* set : sets) {
    parts.push_back({set->value, level_off(set->where.function, length) / length, 1});
    plan.weight.function = plan.weight.function * set->where.function;
    plan.weight.formula += (plan.weight.formula.empty() ? "omega(" : " * omega(") + set->set + ")";
  }
  if (!sets.empty()) plan.given = transfinite(parts);
  Field distance = plan.distance;  // from all that has values
  for (const SetValue* set : sets)
    distance = distance * (level_off(set->where.function, length) / length);
  Field jumps = 0.0;
  for (const InterfaceCondition& interface : options.interfaces)
    if (!interface.jump.is_constant(0))
      jumps =
          jumps + interface.jump * step(interface.omega) *
                      (distance / (distance + pow(level_off(interface.omega, length) / length, 2)));
  if (!jumps.is_constant(0)) plan.given = plan.given + jumps;
  plan.data = plan.given.inhomogeneous();

  const Structure psi = Structure::undetermined(component);
  Structure u = plan.given + plan.weight.function * psi;
  for (const SetValue* set : sets) {
    if (!set->where.surface || !has_both_sides(set->where, rule)) continue;
    Field factor = boundary * *set->where.surface;
    for (const SetValue* other : sets)
      if (other != set) factor = factor * other->where.function;
    u = u + factor * Structure::undetermined(functions++);
  }
  for (const InterfaceCondition& interface : options.interfaces)
    u = u + plan.weight.function * abs(interface.omega) * Structure::undetermined(functions++);
  return u;
}

}  // namespace rfm
