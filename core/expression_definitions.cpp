#include <algorithm>

#include "core/error.hpp"
#include "core/expression_evaluator.hpp"

namespace rfm {

/// A formula whose definitions are being evaluated: the one that is asked for, that of a name, or
/// that of a function, which only leads to the names in it.
struct ExpressionEvaluator::Visit {
  std::string name;
  bool is_function;
  const Expression* formula;
  std::vector<const Node*> next = {};  ///< names and calls in it, those that come first last
  const Node* at = nullptr;            ///< what is being followed
};

ExpressionEvaluator::Visit ExpressionEvaluator::visit(
    const std::string& name, bool is_function, const Expression& formula,
    const std::vector<std::string>* arguments) const {
  Visit visit{name, is_function, &formula};
  const std::vector<bool> is_name_only = arguments_that_are_names(formula);
  const std::span<const Node> nodes = formula.nodes();
  for (std::size_t i = nodes.size(); i-- > 0;) {
    if (is_name_only[i] || (nodes[i].kind != Kind::name && nodes[i].kind != Kind::call)) continue;
    const std::string used(formula.text_of(nodes[i]));
    const bool is_hidden = arguments && std::ranges::find(*arguments, used) != arguments->end() &&
                           (nodes[i].kind == Kind::name || !scope_.user_functions_.contains(used));
    if (!is_hidden) visit.next.push_back(&nodes[i]);
  }
  return visit;
}

// Follows a name or a call to what defines it, if that is not done yet.
void ExpressionEvaluator::enter(std::vector<Visit>& path, std::string name, bool is_call) {
  const auto user = scope_.user_functions_.find(name);
  const bool is_function = is_call && user != scope_.user_functions_.end();
  // f(a, b) or f.dx(a, b), of a function that is a name.
  if (is_call && !is_function && !scope_.names_.contains(name))
    name.resize(std::min(name.rfind('.'), name.size()));
  const auto found = scope_.names_.find(name);
  const bool is_name = !is_function && found != scope_.names_.end() && found->second.formula;
  if (!is_function && !is_name) return;
  const Expression& formula = is_function ? *user->second.formula : *found->second.formula;
  if (is_function ? prepared_.contains(&formula) : definitions_.contains(name)) return;
  if (!open_.insert(&formula).second) {
    std::string cycle;
    for (auto step = std::ranges::find(path, &formula, &Visit::formula); step != path.end(); ++step)
      cycle += step->name + " -> ";
    throw InputError("a definition that uses itself: " + cycle + name, path.front().at->offset,
                     path.front().at->length);
  }
  path.push_back(
      visit(name, is_function, formula, is_function ? &user->second.arguments : nullptr));
}

// All that the last formula of the path uses is defined.
void ExpressionEvaluator::leave(const std::vector<Visit>& path) {
  const Visit& last = path.back();
  prepared_.insert(last.formula);
  if (last.is_function || path.size() == 1) return;
  try {
    definitions_.emplace(last.name, evaluate(*last.formula, nullptr));
  } catch (const InputError& mistake) {
    // Only the innermost definition is named: the chain that leads to it is of no interest.
    const std::string what = mistake.what();
    throw InputError(what.starts_with("in '") ? what : "in '" + last.name + "': " + what,
                     path.front().at->offset, path.front().at->length);
  }
}

// Depth first, with a stack of its own. A mistake in a definition is reported at the name in the
// formula that led there.
void ExpressionEvaluator::define_what_is_used(const Expression& expression) {
  if (prepared_.contains(&expression)) return;
  std::vector<Visit> path{visit("", false, expression, nullptr)};
  while (!path.empty()) {
    Visit& last = path.back();
    if (last.next.empty()) {
      leave(path);
      path.pop_back();
      continue;
    }
    last.at = last.next.back();
    last.next.pop_back();
    enter(path, std::string(last.formula->text_of(*last.at)), last.at->kind == Kind::call);
  }
}

}  // namespace rfm
