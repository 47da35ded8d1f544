#include "problems/custom_physics.hpp"

#include <algorithm>
#include <limits>
#include <map>

#include "core/error.hpp"
#include "core/r_functions.hpp"
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
    if (kind == Kind::energy) Form::energy(formula);
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

void define_own_coefficients(const DocumentNode& map, ValueReader& values,
                             const std::vector<Material>& materials,
                             const std::vector<const DocumentNode*>& of_materials,
                             const std::vector<std::string>& unknowns) {
  struct Own {
    std::optional<Field> standard;
    std::vector<std::pair<Region, Field>> parts;
    Place place;
  };
  std::map<std::string, Own> own;
  const auto read = [&](const DocumentNode& owner, const auto& keep) {
    const DocumentNode* list = values.find(owner, "coefficients");
    if (!list) return;
    for (const DocumentNode::Entry& entry : list->entries) {
      Own& coefficient = own.try_emplace(entry.key, Own{{}, {}, entry.key_place}).first->second;
      if (const std::optional<Field> value = values.field(entry.value)) keep(coefficient, *value);
    }
  };
  read(map, [](Own& coefficient, const Field& value) { coefficient.standard = value; });
  for (std::size_t i = 0; i < materials.size(); ++i)
    read(*of_materials[i], [&](Own& coefficient, const Field& value) {
      if (materials[i].region)
        coefficient.parts.emplace_back(*materials[i].region, value);
      else
        coefficient.standard = value;
    });
  for (const auto& [name, coefficient] : own) {
    std::string objection = objection_to_name(name);
    if (std::ranges::find(unknowns, name) != unknowns.end() || values.scope.has_name(name) ||
        values.scope.has_function(name))
      objection = "the name '" + name + "' is already taken";
    if (!objection.empty()) values.mistakes.add(objection, coefficient.place);
    // Not a number where nothing is given, which assembly reports with the place.
    Field value = coefficient.standard.value_or(std::numeric_limits<double>::quiet_NaN());
    for (const auto& [region, inside] : coefficient.parts)
      value = select(step(implicit(region, RAlpha{1})), inside, value);
    values.scope.define(name, value);
  }
}

CustomPhysics read_custom(const DocumentNode& map, ValueReader& values,
                          const std::vector<std::string>& unknowns,
                          std::map<std::string, PhysicalCoefficient>& coefficients) {
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
  if (const DocumentNode* mass = values.find(map, "mass")) {
    if (custom.kind != Kind::energy)
      values.mistakes.add("modes need an energy beside their mass", mass->place);
    read(*mass);
    coefficients["mass"] = {{custom.formulas.back()}, false, mass->place};
    custom.formulas.pop_back();
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
    if (!formula) {
      form.kind = Kind::residuals;
      formula = values.find(item, "residual");
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
