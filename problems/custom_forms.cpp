#include "problems/custom_forms.hpp"

#include <algorithm>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
#include "problems/result_scope.hpp"
#include "problems/solution_symbols.hpp"
#include "solvers/form_loads.hpp"

namespace rfm {
namespace {

Form form_of(CustomPhysics::Kind kind, const std::vector<Field>& formulas, FormPlace place,
             bool with_loads) {
  switch (kind) {
    case CustomPhysics::Kind::energy:
      return Form::energy(with_loads ? formulas[0] : without_loads(formulas[0]), std::move(place));
    case CustomPhysics::Kind::weak:
      return Form::weak(formulas[0], std::move(place));
    case CustomPhysics::Kind::residuals:
      break;
  }
  return Form::least_squares(formulas, {}, std::move(place));
}

}  // namespace

std::vector<Form> custom_forms(const Problem& problem, const RegionEvaluator& region,
                               const std::vector<int>& bounding_primitives, bool with_loads) {
  const CustomPhysics& custom = *problem.physics.custom;
  std::vector<Form> forms{form_of(custom.kind, custom.formulas, {}, with_loads)};
  for (const CustomPhysics::BoundaryForm& boundary : custom.boundary)
    for (const BoundaryTarget& target : boundary.targets)
      for (const int primitive : bounding_primitives) {
        const std::string& name = region.region().primitives()[primitive]->name;
        if (std::ranges::find(target.pieces, name) == target.pieces.end()) continue;
        ExpressionScope scope = problem.scope;
        define_normal(scope, outward_normal(primitive, region));
        define_symbols(scope, problem.physics.unknowns, problem.dimension);
        if (boundary.kind == CustomPhysics::Kind::weak)
          define_tests(scope, problem.physics.unknowns, problem.dimension);
        forms.push_back(form_of(boundary.kind, {boundary.formula->field(scope)},
                                {Contribution::Place::boundary, {primitive}, target.where_on(name)},
                                with_loads));
      }
  return forms;
}

}  // namespace rfm
