#include <algorithm>
#include <cmath>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/expression_evaluator.hpp"
#include "core/field_node.hpp"
#include "core/field_source.hpp"
#include "core/graph_walk.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

using Node = Expression::Node;

constexpr int deepest_calls = 200;

std::string count_of_arguments(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

void check_count(const std::string& name, const Node& node, std::size_t least, std::size_t most) {
  const std::size_t count = node.argument_count;
  if (count >= least && count <= most) return;
  std::string takes = count_of_arguments(least);
  if (least != most) takes = std::to_string(least) + " to " + count_of_arguments(most);
  if (count < least && (name == "min" || name == "max")) takes = "2 or more arguments";
  throw InputError(name + " takes " + takes + ", got " + std::to_string(count), node.offset,
                   node.length);
}

int orders_taken(const Field::Node& node) {
  if (node.operation == Operation::partial) return 1;
  const bool is_mapped = node.operation == Operation::source && !node.arguments.empty();
  return is_mapped ? degree(source_derivative(node.index)) : 0;
}

// What cannot be evaluated is refused where it is written.
void check_order(const Field& derivative, const Node& node, int highest) {
  const int order = walked<int>(
      derivative, [](const Field&) { return 0; },
      [](const Field& field, const std::vector<int>& orders) {
        return orders_taken(field.node()) + std::ranges::max(orders);
      });
  if (order > highest)
    throw InputError("derivatives of a formula are at most of order " + std::to_string(highest) +
                         ", this one is of order " + std::to_string(order),
                     node.begin, node.end - node.begin);
}

// f.dxy → f and the axes of the derivative; f → f and none.
std::pair<std::string, std::vector<int>> without_derivative(const std::string& name) {
  const std::size_t dot = name.rfind('.');
  std::vector<int> along;
  if (dot != name.npos) along = derivative_axes(std::string_view(name).substr(dot + 1));
  return {along.empty() ? name : name.substr(0, dot), along};
}

}  // namespace

Field apply_simplified(Operation operation, const std::vector<Field>& a) {
  switch (operation) {
    case Operation::add:
      return a[0] + a[1];
    case Operation::subtract:
      return a[0] - a[1];
    case Operation::multiply:
      return a[0] * a[1];
    case Operation::divide:
      return a[0] / a[1];
    case Operation::negate:
      return -a[0];
    case Operation::power:
      return pow(a[0], a[1]);
    case Operation::select:
      return select(a[0], a[1], a[2]);
    default:
      return apply(operation, a);
  }
}

ExpressionValue ExpressionEvaluator::call(const Expression& expression, std::size_t i,
                                          Values& stack, const Locals* locals) {
  const Node& node = expression.nodes()[i];
  const std::string name(expression.text_of(node));
  if (const auto user = scope_.user_functions_.find(name); user != scope_.user_functions_.end())
    return call_user_function(user->second, name, node, take_arguments(stack, node.argument_count));
  if (const ExpressionFunction* function = scope_.find_function(name))
    return call_function(*function, expression, i, stack);
  if (const OperationRow* row = find_operation(std::string_view(name)))
    return call_operation(*row, expression, i, stack);
  if (scope_.is_partial(name)) return call_partial(expression, i, stack);
  return call_at_point(expression, i, stack, locals);
}

ExpressionValue ExpressionEvaluator::call_operation(const OperationRow& row,
                                                    const Expression& expression, std::size_t i,
                                                    Values& stack) const {
  const Node& node = expression.nodes()[i];
  const bool takes_more = row.operation == Operation::min || row.operation == Operation::max;
  const auto arity = static_cast<std::size_t>(row.arity + row.numbers);
  check_count(std::string(row.name), node, arity, takes_more ? node.argument_count : arity);
  const std::vector<Field> arguments =
      scalars(expression, i, take_arguments(stack, node.argument_count));
  if (row.numbers > 0) return with_number(row, expression, i, arguments);
  if (!takes_more) return apply_simplified(row.operation, arguments);
  Field extreme = arguments[0];
  for (std::size_t k = 1; k < arguments.size(); ++k)
    extreme = apply(row.operation, {extreme, arguments[k]});
  return extreme;
}

// The last argument is the number.
Field ExpressionEvaluator::with_number(const OperationRow& row, const Expression& expression,
                                       std::size_t i, std::vector<Field> arguments) const {
  const Node& last = expression.nodes()[i - 1];
  const Field number = result(arguments.back());
  arguments.pop_back();
  const std::string expected =
      objection_to_number(row.operation, number.is_constant() ? number.constant() : std::nan(""));
  if (!expected.empty())
    throw InputError("the last argument of " + std::string(row.name) + " must be " + expected,
                     last.begin, last.end - last.begin);
  return apply(row.operation, std::move(arguments), number.constant());
}

ExpressionValue ExpressionEvaluator::call_function(const ExpressionFunction& function,
                                                   const Expression& expression, std::size_t i,
                                                   Values& stack) const {
  const Node& node = expression.nodes()[i];
  check_count(std::string(expression.text_of(node)), node, function.least_arguments,
              function.most_arguments);
  const std::vector<std::size_t> roots = expression.arguments_of(i);
  const std::size_t without_value = function.takes_names ? roots.size() : function.text_arguments;
  for (std::size_t k = 0; k < function.text_arguments; ++k) {
    const Node& text = expression.nodes()[roots[k]];
    if (text.kind != Kind::text)
      throw InputError("expected a text in quotes", text.begin, text.end - text.begin);
  }
  const Values values = take_arguments(stack, roots.size() - without_value);
  std::vector<ExpressionArgument> arguments;
  for (std::size_t k = 0; k < roots.size(); ++k) {
    const Node& root = expression.nodes()[roots[k]];
    arguments.push_back({expression.text().substr(root.begin, root.end - root.begin), root.begin,
                         root.end - root.begin,
                         k < without_value ? ExpressionValue(0.0) : values[k - without_value]});
  }
  ExpressionValue value = function.call(arguments);
  for (const Field& component : value.components)
    check_order(component, node, scope_.highest_derivative_);
  return value;
}

// A mistake in the function is reported at its call.
ExpressionValue ExpressionEvaluator::call_user_function(
    const ExpressionScope::UserFunction& function, const std::string& name, const Node& node,
    Values values) {
  check_count(name, node, function.arguments.size(), function.arguments.size());
  Locals locals;
  for (std::size_t k = 0; k < values.size(); ++k)
    locals.emplace(function.arguments[k], std::move(values[k]));
  if (++depth_ > deepest_calls)
    throw InputError("functions call one another more than " + std::to_string(deepest_calls) +
                         " deep here (does '" + name + "' call itself?)",
                     node.offset, node.length);
  try {
    ExpressionValue value = evaluate(*function.formula, &locals);
    --depth_;
    return value;
  } catch (const InputError& mistake) {
    // Only the innermost is named: the chain that leads to it is of no interest.
    const std::string what = mistake.what();
    const bool is_named = what.starts_with("in '") || depth_ > deepest_calls;
    throw InputError(is_named ? what : "in '" + name + "': " + what, node.offset, node.length);
  }
}

// dxy(f).
ExpressionValue ExpressionEvaluator::call_partial(const Expression& expression, std::size_t i,
                                                  Values& stack) const {
  const Node& node = expression.nodes()[i];
  const std::string name(expression.text_of(node));
  check_count(name, node, 1, 1);
  const Node& argument = expression.nodes()[i - 1];
  const ExpressionValue value = std::move(take_arguments(stack, 1)[0]);
  if (value.is_vector)
    throw InputError(name + " takes a function, not a vector: choose a component with [0]",
                     argument.begin, argument.end - argument.begin);
  Field derivative = value.components[0];
  for (const int axis : derivative_axes(name)) derivative = partial(derivative, axis);
  check_order(derivative, node, scope_.highest_derivative_);
  return derivative;
}

const ExpressionValue* ExpressionEvaluator::known_value(const std::string& name,
                                                        const Locals* locals) const {
  if (locals)
    if (const auto local = locals->find(name); local != locals->end()) return &local->second;
  const auto found = scope_.names_.find(name);
  if (found == scope_.names_.end()) return nullptr;
  return found->second.formula ? &definitions_.at(name) : &found->second.value;
}

// A function of the coordinates that has a name, at another point: f(a, b), or a derivative of it
// there: f.dx(a, b).
ExpressionValue ExpressionEvaluator::call_at_point(const Expression& expression, std::size_t i,
                                                   Values& stack, const Locals* locals) const {
  const Node& node = expression.nodes()[i];
  const std::string name(expression.text_of(node));
  std::vector<int> along;
  const ExpressionValue* value = known_value(name, locals);
  if (!value) {
    const auto [function, axes] = without_derivative(name);
    value = known_value(function, locals);
    along = axes;
  }
  if (!value || value->is_vector) refuse_function(name, node);
  Field function = value->components[0];
  const Field::Node& inner = function.node();
  if (inner.operation == Operation::constant || inner.operation == Operation::coordinate ||
      inner.operation == Operation::parameter)
    refuse_function(name, node);
  const bool is_sampled = inner.operation == Operation::source && inner.arguments.empty();
  std::size_t dimension = 1;
  for (const char* axis : {"y", "z"}) dimension += scope_.names_.contains(axis) ? 1 : 0;
  if (is_sampled) dimension = static_cast<std::size_t>(inner.source->valid().dimension);
  check_count(name, node, dimension, dimension);
  const std::vector<Field> place = scalars(expression, i, take_arguments(stack, dimension));
  for (const int axis : along) function = partial(function, axis);
  check_order(function, node, scope_.highest_derivative_);
  return compose(function, place);
}

void ExpressionEvaluator::refuse_function(const std::string& name, const Node& node) const {
  const auto refused = scope_.refused_.find(name);
  if (refused != scope_.refused_.end())
    throw InputError("'" + name + "' " + refused->second, node.offset, node.length);
  if (scope_.has_name(name) || name == "pi")
    throw InputError("'" + name + "' is not a function (a product is written with '*')",
                     node.offset, node.length);
  const bool is_high =
      name.size() > 9 && name[0] == 'd' && name.find_first_not_of("xyzt", 1) == name.npos;
  if (is_high && scope_.is_partial("dx"))
    throw InputError("derivatives have at most 8 letters: nest two of them", node.offset,
                     node.length);
  throw InputError("unknown function '" + name + "'" + did_you_mean(name, scope_.functions()),
                   node.offset, node.length);
}

}  // namespace rfm
