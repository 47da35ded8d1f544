#pragma once

#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "core/box.hpp"
#include "core/expression.hpp"
#include "problems/problem.hpp"
#include "problems/result_scope.hpp"
#include "problems/schema_check.hpp"

namespace rfm {

/// Reads values of a checked document. What is wrong is added to the mistakes and read as nothing;
/// so is what the structure check has already refused, without a second report.
class ValueReader {
 public:
  ValueReader(const SchemaMatch& match, MistakeList& mistakes) : match(match), mistakes(mistakes) {}

  const SchemaMatch& match;
  MistakeList& mistakes;
  int dimension = 2;
  /// What numbers may name: parameters and functions.
  ExpressionScope number_scope;
  /// What formulas may name.
  ExpressionScope scope;
  /// Stand-ins for what the problem will have as results.
  ScalarResults results;
  /// The result of another problem file that a map {from: file, field: name} asks for.
  std::function<Field(const DocumentNode&)> result_of_other_problem;

  /// The value of a key of a map, if it is there and fits the table.
  const DocumentNode* find(const DocumentNode& map, std::string_view key) const;
  bool fits(const DocumentNode& node) const { return match.contains(&node); }

  /// A number within the range of its key.
  std::optional<double> number(const DocumentNode& node) const;
  std::optional<int> integer(const DocumentNode& node) const;
  /// One number for each dimension.
  std::optional<Point> point(const DocumentNode& node) const;
  std::optional<std::vector<double>> numbers(const DocumentNode& node) const;
  std::optional<std::vector<int>> integers(const DocumentNode& node) const;
  /// A box {min, max} with min < max along every axis.
  std::optional<Box> box(const DocumentNode& map) const;
  std::optional<Field> field(const DocumentNode& node) const;
  /// A formula, checked in `check_scope`, to be evaluated later.
  std::optional<DeferredExpression> deferred(const DocumentNode& node,
                                             const ExpressionScope& check_scope) const;

  /// Calls `read`; an `InputError` becomes a mistake at its place within `node`.
  template <class Value>
  std::optional<Value> guarded(const DocumentNode& node, std::function<Value()> read) const {
    try {
      return read();
    } catch (const InputError& mistake) {
      mistakes.add(mistake.what(), node.place_within(mistake.offset, mistake.length));
    } catch (const ProblemFileErrors& errors) {
      for (const Mistake& mistake : errors.mistakes)
        mistakes.add(mistake.message, mistake.place, mistake.others);
    }
    return std::nullopt;
  }

 private:
  std::optional<double> number_within(const DocumentNode& node, const SchemaKey& key) const;
  std::optional<int> whole(const DocumentNode& node, double value) const;
};

}  // namespace rfm
