#include "problems/value_reader.hpp"

#include <array>
#include <cmath>
#include <cstdio>

namespace rfm {
namespace {

constexpr const char* axis_names[] = {"x", "y", "z"};

std::string coordinates_text(int dimension) {
  return dimension == 1 ? "[x]" : dimension == 2 ? "[x, y]" : "[x, y, z]";
}

// "-1", or "r = -1" where the text does not show the value.
std::string value_text(const std::string& text, double value) {
  std::array<char, 32> number;
  std::snprintf(number.data(), number.size(), "%g", value);
  const bool is_plain = text.find_first_not_of("+-.0123456789eE") == std::string::npos;
  return is_plain ? text : text + " = " + number.data();
}

}  // namespace

const DocumentNode* ValueReader::find(const DocumentNode& map, std::string_view key) const {
  const DocumentNode* node = map.find(key);
  return node && fits(*node) ? node : nullptr;
}

std::optional<double> ValueReader::number_within(const DocumentNode& node,
                                                 const SchemaKey& key) const {
  if (!node.is_scalar()) {
    mistakes.add("expected a number", node.place);
    return std::nullopt;
  }
  return guarded<double>(node, [&] {
    const double value = to_number(Expression(node.text), number_scope);
    if (!key.range.contains(value))
      throw InputError(
          "expected a number " + key.range.text() + " but found " + value_text(node.text, value), 0,
          node.text.size());
    return value;
  });
}

std::optional<int> ValueReader::whole(const DocumentNode& node, double value) const {
  if (value == std::floor(value) && std::fabs(value) <= 1e9) return static_cast<int>(value);
  mistakes.add("expected a whole number but found " + value_text(node.text, value), node.place);
  return std::nullopt;
}

std::optional<double> ValueReader::number(const DocumentNode& node) const {
  const auto key = match.find(&node);
  if (key == match.end()) return std::nullopt;
  return number_within(node, *key->second);
}

std::optional<int> ValueReader::integer(const DocumentNode& node) const {
  const std::optional<double> value = number(node);
  return value ? whole(node, *value) : std::nullopt;
}

std::optional<std::vector<double>> ValueReader::numbers(const DocumentNode& node) const {
  const auto key = match.find(&node);
  if (key == match.end() || !node.is_list()) return std::nullopt;
  std::vector<double> values;
  for (const DocumentNode& item : node.items)
    if (const std::optional<double> value = number_within(item, *key->second))
      values.push_back(*value);
  if (values.size() < node.items.size()) return std::nullopt;
  return values;
}

std::optional<std::vector<int>> ValueReader::integers(const DocumentNode& node) const {
  const std::optional<std::vector<double>> values = numbers(node);
  if (!values) return std::nullopt;
  std::vector<int> integers;
  for (std::size_t i = 0; i < values->size(); ++i)
    if (const std::optional<int> integer = whole(node.items[i], (*values)[i]))
      integers.push_back(*integer);
  if (integers.size() < values->size()) return std::nullopt;
  return integers;
}

std::optional<Point> ValueReader::point(const DocumentNode& node) const {
  if (!fits(node) || !node.is_list()) return std::nullopt;
  if (static_cast<int>(node.items.size()) != dimension) {
    mistakes.add("expected " + std::to_string(dimension) + " numbers " +
                     coordinates_text(dimension) + " but found " +
                     std::to_string(node.items.size()),
                 node.place);
    return std::nullopt;
  }
  const std::optional<std::vector<double>> values = numbers(node);
  if (!values) return std::nullopt;
  Point point{};
  std::copy(values->begin(), values->end(), point.begin());
  return point;
}

std::optional<Box> ValueReader::box(const DocumentNode& map) const {
  const DocumentNode* min_node = find(map, "min");
  const DocumentNode* max_node = find(map, "max");
  const std::optional<Point> min = min_node ? point(*min_node) : std::nullopt;
  const std::optional<Point> max = max_node ? point(*max_node) : std::nullopt;
  if (!min || !max) return std::nullopt;
  for (int axis = 0; axis < dimension; ++axis)
    if (!((*min)[axis] < (*max)[axis])) {
      mistakes.add(std::string("max must be larger than min along ") + axis_names[axis],
                   max_node->items[static_cast<std::size_t>(axis)].place);
      return std::nullopt;
    }
  return Box{dimension, *min, *max};
}

std::optional<Field> ValueReader::field(const DocumentNode& node) const {
  if (!fits(node)) return std::nullopt;
  if (node.is_map()) return guarded<Field>(node, [&] { return result_of_other_problem(node); });
  if (!node.is_scalar()) return std::nullopt;
  return guarded<Field>(node, [&] { return to_field(Expression(node.text), scope); });
}

std::optional<DeferredExpression> ValueReader::deferred(const DocumentNode& node,
                                                        const ExpressionScope& check_scope) const {
  if (!fits(node) || !node.is_scalar()) return std::nullopt;
  return guarded<DeferredExpression>(node, [&] {
    DeferredExpression expression(node);
    expression.value(check_scope);
    return expression;
  });
}

}  // namespace rfm
