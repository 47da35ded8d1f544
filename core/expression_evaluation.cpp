#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/nearest_name.hpp"

namespace rfm {

namespace {

using Node = Expression::Node;
using Kind = Expression::Node::Kind;

constexpr int most_operations = 1'000'000;
constexpr int deepest_definitions = 200;

std::string count_of_arguments(std::size_t count) {
  return std::to_string(count) + (count == 1 ? " argument" : " arguments");
}

}  // namespace

/// Evaluates one formula and, through it, the definitions it uses. Nodes are in order of
/// evaluation, so long sums cost no stack; definitions recurse, and are limited in depth.
class ExpressionEvaluator {
 public:
  explicit ExpressionEvaluator(const ExpressionScope& scope) : scope_(scope) {}

  using Locals = std::map<std::string, ExpressionValue, std::less<>>;

  ExpressionValue evaluate(const Expression& expression, const Locals* locals) {
    std::vector<ExpressionValue> stack;
    const std::span<const Node> nodes = expression.nodes();
    const std::vector<bool> is_name_only = arguments_that_are_names(expression);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Node& node = nodes[i];
      if (++operations_ > most_operations)
        throw InputError("the expression has more than a million operations", node.offset,
                         node.length);
      if (is_name_only[i]) continue;
      stack.push_back(value_of(expression, i, stack, locals));
    }
    return std::move(stack.back());
  }

 private:
  const ExpressionFunction* function_of(const std::string& name) const {
    const auto found = scope_.functions_.find(name);
    return found == scope_.functions_.end() ? nullptr : &found->second;
  }

  // Marks the nodes below calls such as omega(hole), whose arguments are not evaluated.
  std::vector<bool> arguments_that_are_names(const Expression& expression) const {
    const std::span<const Node> nodes = expression.nodes();
    std::vector<bool> marked(nodes.size(), false);
    for (std::size_t i = nodes.size(); i-- > 0;) {
      if (nodes[i].kind != Kind::call || marked[i]) continue;
      const std::string name(expression.text_of(nodes[i]));
      const ExpressionFunction* function = function_of(name);
      // A function that is refused is so before its arguments are.
      if ((function && function->takes_names) || scope_.refused_.contains(name))
        std::fill(marked.begin() + nodes[i].first, marked.begin() + static_cast<long>(i), true);
      else if (function && function->text_arguments > 0)
        mark_texts(nodes, i, function->text_arguments, marked);
    }
    return marked;
  }

  static void mark_texts(std::span<const Node> nodes, std::size_t call, std::size_t count,
                         std::vector<bool>& marked) {
    const std::vector<std::size_t> roots = argument_roots(nodes, call);
    for (std::size_t k = 0; k < std::min(count, roots.size()); ++k)
      if (nodes[roots[k]].kind == Kind::text) marked[roots[k]] = true;
  }

  static std::vector<ExpressionValue> take_arguments(std::vector<ExpressionValue>& stack,
                                                     std::size_t count) {
    std::vector<ExpressionValue> arguments(
        std::make_move_iterator(stack.end() - static_cast<long>(count)),
        std::make_move_iterator(stack.end()));
    stack.erase(stack.end() - static_cast<long>(count), stack.end());
    return arguments;
  }

  ExpressionValue value_of(const Expression& expression, std::size_t i,
                           std::vector<ExpressionValue>& stack, const Locals* locals) {
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
        return call(expression, i, stack);
    }
    throw InvalidArgument("a node of an expression has no kind");
  }

  ExpressionValue value_of_name(const Expression& expression, const Node& node,
                                const Locals* locals) {
    const std::string name(expression.text_of(node));
    if (locals)
      if (const auto local = locals->find(name); local != locals->end()) return local->second;
    const auto found = scope_.names_.find(name);
    if (found != scope_.names_.end()) {
      if (!found->second.formula) return found->second.value;
      const auto known = definitions_.find(name);
      if (known != definitions_.end()) return known->second;
      ExpressionValue value =
          inside(node, name, [&] { return evaluate(*found->second.formula, nullptr); });
      definitions_.emplace(name, value);
      return value;
    }
    if (name == "pi") return std::numbers::pi;
    refuse_name(name, node, locals);
  }

  // Evaluates a definition; a mistake in it is reported at the name that led there.
  template <class Evaluation>
  ExpressionValue inside(const Node& node, const std::string& name, Evaluation&& evaluation) {
    if (++depth_ > deepest_definitions)
      throw InputError("definitions are nested more than " + std::to_string(deepest_definitions) +
                           " deep here (does '" + name + "' use itself?)",
                       node.offset, node.length);
    try {
      ExpressionValue value = evaluation();
      --depth_;
      return value;
    } catch (const InputError& mistake) {
      const std::string what = mistake.what();
      // Only the innermost definition is named: the chain that leads to it is of no interest.
      const bool is_named = what.starts_with("in '") || depth_ > deepest_definitions;
      throw InputError(is_named ? what : "in '" + name + "': " + what, node.offset, node.length);
    }
  }

  [[noreturn]] void refuse_name(const std::string& name, const Node& node,
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

  const Field& scalar(const Expression& expression, std::size_t root,
                      const ExpressionValue& value) const {
    if (!value.is_vector) return value.components[0];
    const Node& node = expression.nodes()[root];
    throw InputError("a number is needed here, not a vector of " +
                         std::to_string(value.components.size()) +
                         " components: choose one with [0]",
                     node.begin, node.end - node.begin);
  }

  // Roots of the arguments of node i, in order.
  static std::vector<std::size_t> argument_roots(std::span<const Node> nodes, std::size_t i) {
    std::vector<std::size_t> roots(nodes[i].argument_count);
    std::size_t root = i;
    for (std::size_t k = roots.size(); k-- > 0;) {
      root = k + 1 == roots.size() ? i - 1 : nodes[root].first - 1;
      roots[k] = root;
    }
    return roots;
  }

  std::vector<Field> scalars(const Expression& expression, std::size_t i,
                             const std::vector<ExpressionValue>& values) const {
    const std::vector<std::size_t> roots = argument_roots(expression.nodes(), i);
    std::vector<Field> fields;
    for (std::size_t k = 0; k < values.size(); ++k)
      fields.push_back(scalar(expression, roots[k], values[k]));
    return fields;
  }

  ExpressionValue component(const Expression& expression, std::size_t i,
                            const std::vector<ExpressionValue>& values) const {
    const std::vector<std::size_t> roots = argument_roots(expression.nodes(), i);
    const Node& place = expression.nodes()[roots[1]];
    const std::size_t length = place.end - place.begin;
    if (!values[0].is_vector)
      throw InputError("only a vector has components, and this is a number",
                       expression.nodes()[i].offset);
    const Field& index = scalar(expression, roots[1], values[1]);
    const std::size_t size = values[0].components.size();
    const double number = index.is_constant() ? index.constant() : -1.0;
    if (number != std::floor(number) || number < 0 || number >= static_cast<double>(size))
      throw InputError("the index must be a whole number from 0 to " + std::to_string(size - 1),
                       place.begin, length);
    return values[0].components[static_cast<std::size_t>(number)];
  }

  ExpressionValue operation(const Expression& expression, std::size_t i,
                            const std::vector<ExpressionValue>& values) const {
    const Node& node = expression.nodes()[i];
    std::vector<Field> arguments = scalars(expression, i, values);
    if (node.kind == Kind::not_equal) return 1.0 - apply(Operation::equal, std::move(arguments));
    if (expression.text_of(node).starts_with('>')) std::swap(arguments[0], arguments[1]);
    return apply_operation(node.operation, arguments);
  }

  static Field apply_operation(Operation operation, const std::vector<Field>& a) {
    switch (operation) {  // those whose builders simplify
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

  ExpressionValue call(const Expression& expression, std::size_t i,
                       std::vector<ExpressionValue>& stack) {
    const Node& node = expression.nodes()[i];
    const std::string name(expression.text_of(node));
    if (const auto user = scope_.user_functions_.find(name); user != scope_.user_functions_.end())
      return call_user_function(user->second, name, node,
                                take_arguments(stack, node.argument_count));
    if (const ExpressionFunction* function = function_of(name))
      return call_function(*function, name, expression, i, stack);
    const OperationRow* row = find_operation(std::string_view(name));
    if (!row) refuse_function(name, node);
    const bool takes_more = row->operation == Operation::min || row->operation == Operation::max;
    const auto arity = static_cast<std::size_t>(row->arity + row->numbers);
    check_count(name, node, arity, takes_more ? node.argument_count : arity);
    const std::vector<Field> arguments =
        scalars(expression, i, take_arguments(stack, node.argument_count));
    if (row->numbers > 0) return with_number(*row, expression, i, arguments);
    if (!takes_more) return apply_operation(row->operation, arguments);
    Field extreme = arguments[0];
    for (std::size_t k = 1; k < arguments.size(); ++k)
      extreme = apply(row->operation, {extreme, arguments[k]});
    return extreme;
  }

  // The last argument is the number.
  static Field with_number(const OperationRow& row, const Expression& expression, std::size_t i,
                           std::vector<Field> arguments) {
    const Node& last = expression.nodes()[i - 1];
    const Field number = std::move(arguments.back());
    arguments.pop_back();
    const std::string expected =
        objection_to_number(row.operation, number.is_constant() ? number.constant() : std::nan(""));
    if (!expected.empty())
      throw InputError("the last argument of " + std::string(row.name) + " must be " + expected,
                       last.begin, last.end - last.begin);
    return apply(row.operation, std::move(arguments), number.constant());
  }

  ExpressionValue call_function(const ExpressionFunction& function, const std::string& name,
                                const Expression& expression, std::size_t i,
                                std::vector<ExpressionValue>& stack) const {
    const Node& node = expression.nodes()[i];
    check_count(name, node, function.least_arguments, function.most_arguments);
    const std::vector<std::size_t> roots = argument_roots(expression.nodes(), i);
    const std::size_t without_value = function.takes_names ? roots.size() : function.text_arguments;
    for (std::size_t k = 0; k < function.text_arguments; ++k) {
      const Node& text = expression.nodes()[roots[k]];
      if (text.kind != Kind::text)
        throw InputError("expected a text in quotes", text.begin, text.end - text.begin);
    }
    const std::vector<ExpressionValue> values = take_arguments(stack, roots.size() - without_value);
    std::vector<ExpressionArgument> arguments;
    for (std::size_t k = 0; k < roots.size(); ++k) {
      const Node& root = expression.nodes()[roots[k]];
      arguments.push_back({expression.text().substr(root.begin, root.end - root.begin), root.begin,
                           root.end - root.begin,
                           k < without_value ? ExpressionValue(0.0) : values[k - without_value]});
    }
    return function.call(arguments);
  }

  ExpressionValue call_user_function(const ExpressionScope::UserFunction& function,
                                     const std::string& name, const Node& node,
                                     std::vector<ExpressionValue> values) {
    check_count(name, node, function.parameters.size(), function.parameters.size());
    Locals locals;
    for (std::size_t k = 0; k < values.size(); ++k)
      locals.emplace(function.parameters[k], std::move(values[k]));
    return inside(node, name, [&] { return evaluate(*function.formula, &locals); });
  }

  static void check_count(const std::string& name, const Node& node, std::size_t least,
                          std::size_t most) {
    const std::size_t count = node.argument_count;
    if (count >= least && count <= most) return;
    std::string takes = count_of_arguments(least);
    if (least != most) takes = std::to_string(least) + " to " + count_of_arguments(most);
    if (count < least && (name == "min" || name == "max")) takes = "2 or more arguments";
    throw InputError(name + " takes " + takes + ", got " + std::to_string(count), node.offset,
                     node.length);
  }

  [[noreturn]] void refuse_function(const std::string& name, const Node& node) const {
    const auto refused = scope_.refused_.find(name);
    if (refused != scope_.refused_.end())
      throw InputError("'" + name + "' " + refused->second, node.offset, node.length);
    if (scope_.has_name(name) || name == "pi")
      throw InputError("'" + name + "' is not a function (a product is written with '*')",
                       node.offset, node.length);
    throw InputError("unknown function '" + name + "'" + did_you_mean(name, scope_.functions()),
                     node.offset, node.length);
  }

  const ExpressionScope& scope_;
  std::map<std::string, ExpressionValue> definitions_;
  int operations_ = 0;
  int depth_ = 0;
};

ExpressionValue evaluate(const Expression& expression, const ExpressionScope& scope) {
  return ExpressionEvaluator(scope).evaluate(expression, nullptr);
}

Field to_field(const Expression& expression, const ExpressionScope& scope) {
  ExpressionValue value = evaluate(expression, scope);
  if (value.is_vector)
    throw InputError("a number is needed here, not a vector of " +
                         std::to_string(value.components.size()) +
                         " components: choose one with [0]",
                     0, expression.text().size());
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
