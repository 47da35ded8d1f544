#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

#include "core/expression.hpp"

namespace rfm {

/// Evaluates one formula and, through it, the definitions it uses. Nodes are in order of
/// evaluation, so long sums cost no stack; neither do long chains of definitions. Only functions
/// that call one another recurse, and are limited in depth.
class ExpressionEvaluator {
 public:
  explicit ExpressionEvaluator(const ExpressionScope& scope) : scope_(scope) {}

  /// Arguments of a function, by name: they hide other names.
  using Locals = std::map<std::string, ExpressionValue, std::less<>>;
  ExpressionValue evaluate(const Expression& expression, const Locals* locals);

  /// A field as results hold it: with the values of parameters, unless the scope keeps them.
  Field result(const Field& field) const;

 private:
  using Node = Expression::Node;
  using Kind = Expression::Node::Kind;
  using Values = std::vector<ExpressionValue>;

  // Nodes and names (expression_evaluation.cpp).
  std::vector<bool> arguments_that_are_names(const Expression& expression) const;
  ExpressionValue value_of(const Expression& expression, std::size_t i, Values& stack,
                           const Locals* locals);
  ExpressionValue value_of_name(const Expression& expression, const Node& node,
                                const Locals* locals);
  [[noreturn]] void refuse_name(const std::string& name, const Node& node,
                                const Locals* locals) const;
  const Field& scalar(const Expression& expression, std::size_t root,
                      const ExpressionValue& value) const;
  std::vector<Field> scalars(const Expression& expression, std::size_t i,
                             const Values& values) const;
  ExpressionValue component(const Expression& expression, std::size_t i,
                            const Values& values) const;
  ExpressionValue operation(const Expression& expression, std::size_t i,
                            const Values& values) const;

  // Definitions (expression_definitions.cpp).
  struct Visit;
  void define_what_is_used(const Expression& expression);
  Visit visit(const std::string& name, bool is_function, const Expression& formula,
              const std::vector<std::string>* arguments) const;
  void enter(std::vector<Visit>& path, std::string name, bool is_call);
  void leave(const std::vector<Visit>& path);

  // Calls (expression_calls.cpp).
  ExpressionValue call(const Expression& expression, std::size_t i, Values& stack,
                       const Locals* locals);
  ExpressionValue call_operation(const OperationRow& row, const Expression& expression,
                                 std::size_t i, Values& stack) const;
  Field with_number(const OperationRow& row, const Expression& expression, std::size_t i,
                    std::vector<Field> arguments) const;
  ExpressionValue call_function(const ExpressionFunction& function, const Expression& expression,
                                std::size_t i, Values& stack) const;
  ExpressionValue call_user_function(const ExpressionScope::UserFunction& function,
                                     const std::string& name, const Node& node, Values values);
  ExpressionValue call_partial(const Expression& expression, std::size_t i, Values& stack) const;
  const ExpressionValue* known_value(const std::string& name, const Locals* locals) const;
  ExpressionValue call_at_point(const Expression& expression, std::size_t i, Values& stack,
                                const Locals* locals) const;
  [[noreturn]] void refuse_function(const std::string& name, const Node& node) const;

  static Values take_arguments(Values& stack, std::size_t count) {
    Values arguments(std::make_move_iterator(stack.end() - static_cast<long>(count)),
                     std::make_move_iterator(stack.end()));
    stack.erase(stack.end() - static_cast<long>(count), stack.end());
    return arguments;
  }

  const ExpressionScope& scope_;
  std::map<std::string, ExpressionValue, std::less<>> definitions_;
  std::set<const Expression*> prepared_;  ///< all that they use is defined
  std::set<const Expression*> open_;      ///< on the way to that
  int operations_ = 0;
  int depth_ = 0;
};

/// `operation` by the builder that simplifies, where there is one.
Field apply_simplified(Operation operation, const std::vector<Field>& arguments);

}  // namespace rfm
