#include "core/diagnosis.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unordered_map>

#include "core/expression_text.hpp"
#include "core/expression_tokens.hpp"
#include "core/named_source.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

std::string short_number(double value, int digits = 6) {
  char text[40];
  std::snprintf(text, sizeof text, "%.*g", digits, value);
  return text;
}

/// The jets of all nodes of a graph at one point, each up to the order that its users need.
class GraphValues {
 public:
  GraphValues(const Field& root, const Point& point, int dimension, double time,
              std::span<const double> given)
      : dimension_(dimension), tape_{collect(root), orders_, dimension}, workspace_(tape_) {
    PointBlock block;
    for (int axis = 0; axis < 3; ++axis) block.coordinates[axis] = &point[axis];
    block.count = 1;
    block.time = time;
    std::vector<double> parameters(given.begin(), given.end());
    parameters.resize(std::max<std::size_t>(parameters.size(), parameter_count_), std::nan(""));
    block.parameters = parameters;
    tape_.evaluate(block, workspace_);
  }

  double value(const Field& field) const {
    return workspace_.coefficient(place_.at(&field.node()))[0];
  }
  /// Whether value and derivatives up to `order` are finite.
  bool is_finite(const Field& field, int order) const {
    return all(field, order, [](double c) { return std::isfinite(c); });
  }
  /// Whether they are numbers, infinite ones included.
  bool is_number(const Field& field, int order) const {
    return all(field, order, [](double c) { return !std::isnan(c); });
  }

 private:
  bool all(const Field& field, int order, const auto& holds) const {
    const int root = place_.at(&field.node());
    for (int i = 0; i < jet_size(dimension_, order); ++i)
      if (!holds(workspace_.coefficient(root, i)[0])) return false;
    return true;
  }

  // Nodes of the graph as roots, users before arguments, and the orders that they need.
  std::vector<Field> collect(const Field& root) {
    std::vector<std::pair<Field, bool>> pending{{root, false}};
    std::vector<Field> nodes;
    while (!pending.empty()) {
      const auto [field, done] = std::move(pending.back());
      pending.pop_back();
      if (done) {
        nodes.push_back(field);
        continue;
      }
      if (!place_.try_emplace(&field.node(), 0).second) continue;
      pending.emplace_back(field, true);
      for (const Field& argument : field.node().arguments) pending.emplace_back(argument, false);
    }
    std::reverse(nodes.begin(), nodes.end());
    for (std::size_t i = 0; i < nodes.size(); ++i) place_[&nodes[i].node()] = static_cast<int>(i);
    orders_.assign(nodes.size(), 0);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const Field::Node& node = nodes[i].node();
      if (node.operation == Operation::parameter)
        parameter_count_ = std::max(parameter_count_, static_cast<std::size_t>(node.index) + 1);
      const int needed = orders_[i] + (node.operation == Operation::partial ? 1 : 0);
      for (const Field& argument : node.arguments) {
        int& order = orders_[static_cast<std::size_t>(place_.at(&argument.node()))];
        order = std::max(order, needed);
      }
    }
    return nodes;
  }

  int dimension_;
  std::unordered_map<const Field::Node*, int> place_;
  std::vector<int> orders_;
  std::size_t parameter_count_ = 0;
  Tape tape_;
  Tape::Workspace workspace_;
};

std::string box_text(const Box& box) {
  std::string text;
  for (int axis = 0; axis < box.dimension; ++axis)
    text += (axis > 0 ? " x [" : "[") + short_number(box.low[axis]) + ", " +
            short_number(box.high[axis]) + "]";
  return text;
}

// The operation with the values of its arguments.
std::string call_text(const Field::Node& node, const std::vector<double>& values) {
  const OperationRow& row = *find_operation(node.operation);
  if (node.operation == Operation::integer_power || node.operation == Operation::real_power)
    return short_number(values[0]) + "^" + short_number(node.number);
  const std::string name(row.name);
  if (values.size() == 2 && !is_name(name))
    return short_number(values[0]) + " " + name + " " + short_number(values[1]);
  std::string text = name + "(";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i > 0 ? ", " : "") + short_number(values[i]);
  if (row.numbers > 0) text += ", " + short_number(node.number);
  return text + ")";
}

std::string formula_text(const Field& field) {
  ExpressionTextOptions options;
  options.abbreviated = true;
  options.longest = 60;
  return to_text(field, options);
}

// What fails at a node whose arguments are finite.
std::string failure_text(const Field& field, const GraphValues& values) {
  const Field::Node& node = field.node();
  const double value = values.value(field);
  const std::string formula = formula_text(field);
  switch (node.operation) {
    case Operation::constant:
      return "the number " + formula;
    case Operation::coordinate:
      return formula + " = " + short_number(value);
    case Operation::parameter:
      return "parameter number " + std::to_string(node.index) + " has no finite value";
    case Operation::source:
      if (const auto* named = dynamic_cast<const NamedSource*>(node.source.get()))
        if (std::isnan(value)) return named->outside_text();
      return std::isnan(value)
                 ? "a sampled field outside its region " + box_text(node.source->valid())
                 : "a sampled field that is infinite";
    default:
      break;
  }
  if (!find_operation(node.operation)) return "a value that is not finite in " + formula;
  std::vector<double> arguments;
  for (const Field& argument : node.arguments) arguments.push_back(values.value(argument));
  const std::string call = call_text(node, arguments);
  return (std::isfinite(value) ? "a derivative of " : "") + call + " in " + formula;
}

}  // namespace

std::string diagnose(const Field& field, const Point& point, int dimension, double time,
                     std::span<const double> parameters) {
  const GraphValues values(field, point, dimension, time, parameters);
  if (values.is_finite(field, 0)) return "";
  int order = 0;
  for (Field part = field;;) {
    const Field::Node& node = part.node();
    const int needed = order + (node.operation == Operation::partial ? 1 : 0);
    // An infinite argument may be harmless: min(1/x, sqrt(y)) at (0, -1) fails by the root.
    const Field *culprit = nullptr, *infinite = nullptr;
    for (std::size_t i = 0; i < node.arguments.size() && !culprit; ++i) {
      const Field& argument = node.arguments[i];
      const bool not_taken = node.operation == Operation::select && i > 0 &&
                             (values.value(node.arguments[0]) != 0) != (i == 1);
      if (not_taken || values.is_finite(argument, needed)) continue;
      if (!values.is_number(argument, needed))
        culprit = &argument;
      else if (!infinite)
        infinite = &argument;
    }
    if (!culprit) culprit = infinite;
    if (!culprit) return failure_text(part, values);
    order = needed;
    part = Field(*culprit);
  }
}

std::string diagnosis_suffix(const Field& field, const Point& point, int dimension, double time,
                             std::span<const double> parameters) {
  const std::string cause = diagnose(field, point, dimension, time, parameters);
  return cause.empty() ? "" : ": " + cause;
}

std::string point_text(const Point& point, int dimension) {
  std::string text = "(";
  for (int axis = 0; axis < dimension; ++axis)
    text += (axis > 0 ? ", " : "") + short_number(point[axis], 10);
  return text + ")";
}

}  // namespace rfm
