#include "problems/result_scope.hpp"

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

}  // namespace

void define_normal(ExpressionScope& scope, const std::vector<Field>& normal) {
  define_vector(scope, "n", normal);
}

void define_results(ExpressionScope& scope, const ScalarResults& results) {
  scope.define("u", results.unknown);
  define_vector(scope, "gradient", gradient(results.unknown, results.dimension));
  define_vector(scope, "flux", results.flux);
}

void define_boundary_results(ExpressionScope& scope, const ScalarResults& results,
                             const std::vector<Field>& normal) {
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

void refuse_results(ExpressionScope& scope, int dimension, const std::string& reason) {
  scope.refuse("u", reason);
  refuse_vector(scope, "gradient", reason);
  refuse_vector(scope, "flux", reason);
  scope.refuse("flux.n", reason);
  for (int axis = dimension; axis < 3; ++axis)
    for (const std::string name : {"gradient", "flux"})
      scope.refuse(component_name(name, static_cast<std::size_t>(axis)),
                   "does not exist in dimension " + std::to_string(dimension));
}

ScalarResults stand_in_results(int dimension) {
  return {x_coordinate(), std::vector<Field>(static_cast<std::size_t>(dimension), x_coordinate()),
          dimension};
}

std::vector<Field> stand_in_normal(int dimension) {
  return std::vector<Field>(static_cast<std::size_t>(dimension), x_coordinate());
}

std::vector<std::string> scalar_output_names() { return {"u", "gradient", "flux"}; }

}  // namespace rfm
