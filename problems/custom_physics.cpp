#include "problems/custom_physics.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "problems/reserved_names.hpp"
#include "problems/result_scope.hpp"
#include "problems/solution_symbols.hpp"
#include "solvers/form.hpp"

namespace rfm {
namespace {

using Kind = CustomPhysics::Kind;

ExpressionScope form_scope(const ValueReader& values, const std::vector<std::string>& unknowns,
                           bool has_tests) {
  ExpressionScope scope = values.scope;
  define_symbols(scope, unknowns, values.dimension);
  if (has_tests)
    define_tests(scope, unknowns, values.dimension);
  else
    scope.define_function(
        "test", {.call = [](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
                   throw InputError("only a weak form has test functions", arguments[0].offset,
                                    arguments[0].length);
                 },
                 .takes_names = true});
  return scope;
}

// That the formula is a form of its kind is seen by making one.
void check_form(const Field& formula, Kind kind) {
  try {
    if (kind == Kind::weak) Form::weak(formula);
  } catch (const InvalidArgument& error) {
    throw InputError(error.what(), 0, 0);
  }
}

}  // namespace

std::vector<std::string> unknown_names(const DocumentNode& root, ValueReader& values) {
  const DocumentNode* physics = values.find(root, "physics");
  const DocumentNode* list = physics ? values.find(*physics, "unknowns") : nullptr;
  if (!list) return {"u"};
  std::vector<std::string> names;
  for (const DocumentNode& item : list->items) {
    if (!values.fits(item)) continue;
    const bool is_known = std::ranges::find(names, item.text) != names.end();
    const std::string objection = is_known           ? "'" + item.text + "' is named twice"
                                  : item.text == "u" ? ""
                                                     : objection_to_name(item.text);
    for (const char* key : {"parameters", "fields", "functions"})
      if (const DocumentNode* map = root.find(key); map && map->is_map() && map->find(item.text))
        values.mistakes.add("the name '" + item.text + "' is already one of " + key, item.place);
    if (objection.empty())
      names.push_back(item.text);
    else
      values.mistakes.add(objection, item.place);
  }
  if (list->items.empty())
    values.mistakes.add("expected the name of an unknown, or several", list->place);
  return names.empty() ? std::vector<std::string>{"u"} : names;
}

CustomPhysics read_custom(const DocumentNode& map, ValueReader& values,
                          const std::vector<std::string>& unknowns) {
  CustomPhysics custom;
  custom.place = map.place;
  const auto read = [&](const DocumentNode& node) {
    const ExpressionScope scope = form_scope(values, unknowns, custom.kind == Kind::weak);
    const auto formula = values.guarded<Field>(node, [&] {
      Field field = to_field(Expression(node.text), scope);
      check_form(field, custom.kind);
      return field;
    });
    custom.formulas.push_back(formula.value_or(0.0));
  };
  if (const DocumentNode* energy = values.find(map, "energy")) {
    read(*energy);
  } else if (const DocumentNode* weak = values.find(map, "weak")) {
    custom.kind = Kind::weak;
    read(*weak);
  } else if (const DocumentNode* residuals = values.find(map, "residuals")) {
    custom.kind = Kind::residuals;
    for (const DocumentNode& item : residuals->items)
      if (values.fits(item)) read(item);
    if (residuals->items.empty())
      values.mistakes.add("expected a residual, or several", residuals->place);
  }
  return custom;
}

void read_custom_boundary(const DocumentNode& root, ValueReader& values, BoundaryReader& boundary,
                          Problem& problem) {
  if (!problem.physics.custom) return;
  const DocumentNode* physics = values.find(root, "physics");
  const DocumentNode* list = values.find(*physics, "boundary");
  if (!list) return;
  for (const DocumentNode& item : list->items) {
    if (!values.fits(item)) continue;
    CustomPhysics::BoundaryForm form;
    form.place = item.place;
    if (const DocumentNode* at = values.find(item, "at")) form.targets = boundary.targets(*at);
    for (const BoundaryTarget& target : form.targets)
      if (target.kind == BoundaryTarget::Kind::rest)
        values.mistakes.add("'rest' is what no other condition names: an integral needs a name",
                            target.place);
    const DocumentNode* formula = values.find(item, "energy");
    if (!formula) {
      form.kind = Kind::weak;
      formula = values.find(item, "weak");
    }
    if (!formula) continue;
    ExpressionScope scope = form_scope(values, problem.physics.unknowns, form.kind == Kind::weak);
    define_normal(scope, stand_in_normal(values.dimension));
    form.formula = values.deferred(*formula, scope);
    if (form.formula)
      values.guarded<bool>(*formula, [&] {
        check_form(form.formula->field(scope), form.kind);
        return true;
      });
    problem.physics.custom->boundary.push_back(std::move(form));
  }
}

}  // namespace rfm
