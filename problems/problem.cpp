#include "problems/problem.hpp"

namespace rfm {
namespace {

[[noreturn]] void report(const DocumentNode& node, const InputError& mistake) {
  throw ProblemFileErrors({{mistake.what(), node.place_within(mistake.offset, mistake.length)}});
}

Expression parsed(const DocumentNode& node) {
  try {
    return Expression(node.text);
  } catch (const InputError& mistake) {
    report(node, mistake);
  }
}

}  // namespace

DeferredExpression::DeferredExpression(DocumentNode node)
    : node_(std::move(node)), expression_(parsed(node_)) {}

ExpressionValue DeferredExpression::value(const ExpressionScope& scope) const {
  try {
    return evaluate(expression_, scope);
  } catch (const InputError& mistake) {
    report(node_, mistake);
  }
}

Field DeferredExpression::field(const ExpressionScope& scope) const {
  try {
    return to_field(expression_, scope);
  } catch (const InputError& mistake) {
    report(node_, mistake);
  }
}

std::optional<Field> BoundaryTarget::where_on(const std::string& piece) const {
  const auto part = parts.find(piece);
  return part == parts.end() ? where : part->second;
}

}  // namespace rfm
