#include "core/diagnosis.hpp"

#include <cmath>
#include <cstdio>

#include "core/tape.hpp"

namespace rfm {
namespace {

std::string number_text(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.6g", value);
  return text;
}

// The operation with the values of its arguments.
std::string call_text(const Field::Node& node, const std::vector<double>& values) {
  switch (node.operation) {
    case Operation::constant:
      return "the number " + number_text(node.number);
    case Operation::parameter:
      return "parameter number " + std::to_string(node.index);
    case Operation::source:
      return "a sampled field outside its region";
    case Operation::partial:
      return std::string("d/d") + "xyz"[node.index] + " of a function that is not differentiable";
    case Operation::integer_power:
    case Operation::real_power:
      return number_text(values[0]) + "^" + number_text(node.number);
    default:
      break;
  }
  const std::string name(find_operation(node.operation)->name);
  const bool is_infix = values.size() == 2 && !std::isalpha(static_cast<unsigned char>(name[0]));
  if (is_infix) return number_text(values[0]) + " " + name + " " + number_text(values[1]);
  std::string text = name + "(";
  for (std::size_t i = 0; i < values.size(); ++i)
    text += (i > 0 ? ", " : "") + number_text(values[i]);
  return text + ")";
}

}  // namespace

std::string diagnose(const Field& field, const Point& point, int dimension) {
  const auto value_of = [&](const Field& part) {
    return Tape({part}, {0}, dimension).value(point);
  };
  if (std::isfinite(value_of(field))) return "";
  for (Field part = field;;) {
    const Field::Node& node = part.node();
    std::vector<double> values;
    for (const Field& argument : node.arguments) values.push_back(value_of(argument));
    const Field* culprit = nullptr;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const bool not_taken =
          node.operation == Operation::select && i > 0 && (values[0] != 0) != (i == 1);
      if (!culprit && !not_taken && !std::isfinite(values[i])) culprit = &node.arguments[i];
    }
    if (!culprit) return call_text(node, values);
    part = Field(*culprit);
  }
}

}  // namespace rfm
