#include "problems/result_scope.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/graph_walk.hpp"

namespace rfm {
namespace {

constexpr std::string_view axes = "xyz";

std::string component_name(const std::string& name, std::size_t axis) {
  return name + "." + axes[axis];
}

void define_vector(ExpressionScope& scope, const std::string& name,
                   const std::vector<Field>& components) {
  scope.define(name, ExpressionValue(components));
  for (std::size_t axis = 0; axis < components.size(); ++axis)
    scope.define(component_name(name, axis), components[axis]);
}

void refuse_vector(ExpressionScope& scope, const std::string& name, const std::string& reason) {
  scope.refuse(name, reason);
  for (std::size_t axis = 0; axis < axes.size(); ++axis)
    scope.refuse(component_name(name, axis), reason);
}

bool depends_on(const Field& f, const std::vector<Field>& parts) {
  return any_node(f, [&](const Field& node) {
    return std::ranges::any_of(
        parts, [&](const Field& part) { return node.same_as(part) && !part.is_constant(); });
  });
}

// d(f, k) as it was, but not of results with respect to a parameter.
void refuse_sensitivities(ExpressionScope& scope, std::vector<Field> results) {
  const ExpressionFunction* known = scope.find_function("d");
  if (!known) return;
  ExpressionFunction guarded = *known;
  guarded.call = [call = known->call, results = std::move(results)](
                     std::span<const ExpressionArgument> arguments) -> ExpressionValue {
    const ExpressionArgument& f = arguments[0];
    const bool by_parameter =
        arguments[1].value.components[0].node().operation == Operation::parameter;
    if (by_parameter && std::ranges::any_of(f.value.components, [&](const Field& component) {
          return depends_on(component, results);
        }))
      throw InputError(
          "the solution depends on '" + arguments[1].text +
              "' in a way that a formula does not know: solve with two values and compare",
          f.offset, f.length);
    return call(arguments);
  };
  scope.define_function("d", std::move(guarded));
}

}  // namespace

void define_normal(ExpressionScope& scope, const std::vector<Field>& normal) {
  define_vector(scope, "n", normal);
}

void define_results(ExpressionScope& scope, const ScalarResults& results) {
  std::vector<Field> all = results.flux;
  for (const auto& [name, field] : results.unknowns) {
    scope.define(name, field);
    all.push_back(field);
  }
  for (std::size_t i = 0; i < results.modes.size(); ++i) {
    const std::vector<Field>& mode = results.modes[i];
    scope.define(mode_name(i), mode.size() > 1 ? ExpressionValue(mode) : mode[0]);
    for (std::size_t c = 0; c < mode.size() && mode.size() > 1; ++c)
      scope.define(mode_name(i) + "." + results.unknowns[c].name, mode[c]);
    all.insert(all.end(), mode.begin(), mode.end());
  }
  if (results.unknowns.size() == 1)
    define_vector(scope, "gradient", gradient(results.unknowns[0].field, results.dimension));
  if (!results.flux.empty()) define_vector(scope, "flux", results.flux);
  refuse_sensitivities(scope, std::move(all));
}

void define_boundary_results(ExpressionScope& scope, const ScalarResults& results,
                             const std::vector<Field>& normal) {
  if (results.flux.empty()) return;
  Field outward = 0.0;
  for (std::size_t axis = 0; axis < normal.size(); ++axis)
    outward = outward + results.flux[axis] * normal[axis];
  scope.define("flux.n", outward);
}

void refuse_normal(ExpressionScope& scope, int dimension, const std::string& reason) {
  refuse_vector(scope, "n", reason);
  scope.refuse("flux.n", reason);
  for (int axis = dimension; axis < 3; ++axis)
    scope.refuse(component_name("n", static_cast<std::size_t>(axis)),
                 "does not exist in dimension " + std::to_string(dimension));
}

void refuse_results(ExpressionScope& scope, const ScalarResults& results,
                    const std::string& reason) {
  for (const auto& [name, field] : results.unknowns) scope.refuse(name, reason);
  refuse_vector(scope, "gradient", reason);
  refuse_vector(scope, "flux", reason);
  scope.refuse("flux.n", reason);
  for (int axis = results.dimension; axis < 3; ++axis)
    for (const std::string name : {"gradient", "flux"})
      scope.refuse(component_name(name, static_cast<std::size_t>(axis)),
                   "does not exist in dimension " + std::to_string(results.dimension));
}

ScalarResults stand_in_results(const std::vector<std::string>& unknowns, bool has_flux,
                               int dimension, int modes) {
  const Field any = sin(x_coordinate());
  ScalarResults results{{}, {}, dimension};
  for (const std::string& name : unknowns) results.unknowns.push_back({name, any});
  if (has_flux) results.flux.assign(static_cast<std::size_t>(dimension), any);
  results.modes.assign(static_cast<std::size_t>(modes), std::vector<Field>(unknowns.size(), any));
  return results;
}

std::vector<Field> stand_in_normal(int dimension) {
  return std::vector<Field>(static_cast<std::size_t>(dimension), x_coordinate());
}

std::string mode_name(std::size_t number) { return "mode" + std::to_string(number + 1); }

std::vector<std::string> mode_parts(const ScalarResults& results, std::size_t number) {
  const std::size_t count = results.unknowns.size();
  if (count == 1 || count == static_cast<std::size_t>(results.dimension))
    return {mode_name(number)};
  std::vector<std::string> parts;
  for (const auto& [name, field] : results.unknowns)
    parts.push_back(mode_name(number) + "." + name);
  return parts;
}

std::vector<std::string> output_names(const ScalarResults& results) {
  std::vector<std::string> names;
  for (const auto& [name, field] : results.unknowns) names.push_back(name);
  if (results.unknowns.size() == 1) names.emplace_back("gradient");
  if (!results.flux.empty()) names.emplace_back("flux");
  for (std::size_t i = 0; i < results.modes.size(); ++i) {
    names.push_back(mode_name(i));
    if (results.unknowns.size() > 1)
      for (const auto& [name, field] : results.unknowns) names.push_back(mode_name(i) + "." + name);
  }
  return names;
}

}  // namespace rfm
