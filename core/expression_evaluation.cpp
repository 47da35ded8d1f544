#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/expression_evaluator.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

constexpr int most_operations = 1'000'000;

InputError not_a_vector(const ExpressionValue& value, std::size_t offset, std::size_t length) {
  return InputError("a number is needed here, not a vector of " +
                        std::to_string(value.components.size()) +
                        " components: choose one with [0]",
                    offset, length);
}

}  // namespace

ExpressionValue ExpressionEvaluator::evaluate(const Expression& expression, const Locals* locals) {
  define_what_is_used(expression);
  Values stack;
  const std::span<const Node> nodes = expression.nodes();
  const std::vector<bool> is_name_only = arguments_that_are_names(expression);
  for (std::size_t i = 0; i < nodes.size(); ++i) {
    if (++operations_ > most_operations)
      throw InputError("the expression has more than a million operations", nodes[i].offset,
                       nodes[i].length);
    if (!is_name_only[i]) stack.push_back(value_of(expression, i, stack, locals));
  }
  return std::move(stack.back());
}

Field ExpressionEvaluator::result(const Field& field) const {
  const bool as_it_is = scope_.keeps_parameters_ || scope_.parameters_.size() == 0;
  return as_it_is ? field : with_values(field, scope_.parameters_);
}

// Marks the nodes below calls such as omega(hole), whose arguments are not evaluated.
std::vector<bool> ExpressionEvaluator::arguments_that_are_names(
    const Expression& expression) const {
  const std::span<const Node> nodes = expression.nodes();
  std::vector<bool> marked(nodes.size(), false);
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (nodes[i].kind != Kind::call || marked[i]) continue;
    const std::string name(expression.text_of(nodes[i]));
    const ExpressionFunction* function = scope_.find_function(name);
    // A function that is refused is so before its arguments are.
    if ((function && function->takes_names) || scope_.refused_.contains(name)) {
      std::fill(marked.begin() + nodes[i].first, marked.begin() + static_cast<long>(i), true);
    } else if (function && function->text_arguments > 0) {
      const std::vector<std::size_t> roots = expression.arguments_of(i);
      for (std::size_t k = 0; k < std::min(function->text_arguments, roots.size()); ++k)
        if (nodes[roots[k]].kind == Kind::text) marked[roots[k]] = true;
    }
  }
  return marked;
}

ExpressionValue ExpressionEvaluator::value_of(const Expression& expression, std::size_t i,
                                              Values& stack, const Locals* locals) {
  const Node& node = expression.nodes()[i];
  switch (node.kind) {
    case Kind::number:
      return node.number;
    case Kind::text:
      throw InputError("a quoted text is not a number", node.offset, node.length);
    case Kind::name:
      return value_of_name(expression, node, locals);
    case Kind::index:
      return component(expression, i, take_arguments(stack, 2));
    case Kind::operation:
    case Kind::not_equal:
      return operation(expression, i, take_arguments(stack, node.argument_count));
    case Kind::call:
      return call(expression, i, stack, locals);
  }
  throw InvalidArgument("a node of an expression has no kind");
}

ExpressionValue ExpressionEvaluator::value_of_name(const Expression& expression, const Node& node,
                                                   const Locals* locals) {
  const std::string name(expression.text_of(node));
  if (locals)
    if (const auto local = locals->find(name); local != locals->end()) return local->second;
  if (const auto found = scope_.names_.find(name); found != scope_.names_.end())
    return found->second.formula ? definitions_.at(name) : found->second.value;
  if (name == "pi") return std::numbers::pi;
  refuse_name(name, node, locals);
}

void ExpressionEvaluator::refuse_name(const std::string& name, const Node& node,
                                      const Locals* locals) const {
  const auto refused = scope_.refused_.find(name);
  if (refused != scope_.refused_.end())
    throw InputError("'" + name + "' " + refused->second, node.offset, node.length);
  if (scope_.has_function(name))
    throw InputError("'" + name + "' is a function: write " + name + "(...)", node.offset,
                     node.length);
  std::vector<std::string> known = scope_.names();
  if (locals)
    for (const auto& [local, value] : *locals) known.push_back(local);
  throw InputError("unknown name '" + name + "'" + did_you_mean(name, known), node.offset,
                   node.length);
}

const Field& ExpressionEvaluator::scalar(const Expression& expression, std::size_t root,
                                         const ExpressionValue& value) const {
  if (!value.is_vector) return value.components[0];
  const Node& node = expression.nodes()[root];
  throw not_a_vector(value, node.begin, node.end - node.begin);
}

std::vector<Field> ExpressionEvaluator::scalars(const Expression& expression, std::size_t i,
                                                const Values& values) const {
  const std::vector<std::size_t> roots = expression.arguments_of(i);
  std::vector<Field> fields;
  for (std::size_t k = 0; k < values.size(); ++k)
    fields.push_back(scalar(expression, roots[k], values[k]));
  return fields;
}

ExpressionValue ExpressionEvaluator::component(const Expression& expression, std::size_t i,
                                               const Values& values) const {
  const std::vector<std::size_t> roots = expression.arguments_of(i);
  const Node& place = expression.nodes()[roots[1]];
  if (!values[0].is_vector)
    throw InputError("only a vector has components, and this is a number",
                     expression.nodes()[i].offset);
  const Field index = result(scalar(expression, roots[1], values[1]));
  const std::size_t size = values[0].components.size();
  const double number = index.is_constant() ? index.constant() : -1.0;
  if (number != std::floor(number) || number < 0 || number >= static_cast<double>(size))
    throw InputError("the index must be a whole number from 0 to " + std::to_string(size - 1),
                     place.begin, place.end - place.begin);
  return values[0].components[static_cast<std::size_t>(number)];
}

ExpressionValue ExpressionEvaluator::operation(const Expression& expression, std::size_t i,
                                               const Values& values) const {
  const Node& node = expression.nodes()[i];
  std::vector<Field> arguments = scalars(expression, i, values);
  if (node.kind == Kind::not_equal) return 1.0 - apply(Operation::equal, std::move(arguments));
  if (expression.text_of(node).starts_with('>')) std::swap(arguments[0], arguments[1]);
  return apply_simplified(node.operation, arguments);
}

ExpressionValue evaluate(const Expression& expression, const ExpressionScope& scope) {
  ExpressionEvaluator evaluator(scope);
  ExpressionValue value = evaluator.evaluate(expression, nullptr);
  for (Field& component : value.components) component = evaluator.result(component);
  return value;
}

Field to_field(const Expression& expression, const ExpressionScope& scope) {
  ExpressionValue value = evaluate(expression, scope);
  if (value.is_vector) throw not_a_vector(value, 0, expression.text().size());
  return std::move(value.components[0]);
}

double to_number(const Expression& expression, const ExpressionScope& scope) {
  const Field field = to_field(expression, scope);
  // Constants fold when a field is built, except to what is not a finite number.
  if (!field.is_constant() || !std::isfinite(field.constant()))
    throw InputError("the value is not a finite number", 0, expression.text().size());
  return field.constant();
}

}  // namespace rfm
