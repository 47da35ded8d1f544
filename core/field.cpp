#include "core/field.hpp"

#include <atomic>
#include <cmath>
#include <limits>

#include "core/error.hpp"
#include "core/operation_rules.hpp"

namespace rfm {
namespace {

Field make(Operation operation, std::vector<Field> arguments, double number = 0, int index = 0) {
  auto node = std::make_shared<Field::Node>();
  node->operation = operation;
  node->number = number;
  node->index = index;
  if (const OperationRow* row = find_operation(operation)) {
    const bool divides_by_number = operation == Operation::divide && arguments[1].is_constant() &&
                                   !arguments[1].is_constant(0);
    node->defined_everywhere = divides_by_number || is_defined_everywhere(*row, number);
  }
  for (const Field& argument : arguments)
    node->defined_everywhere &= argument.node().defined_everywhere;
  node->arguments = std::move(arguments);
  return Field(std::shared_ptr<const Field::Node>(std::move(node)));
}

// A fold that would give NaN is left for evaluation, which can say where it happened.
bool fold(Operation operation, const std::vector<Field>& arguments, double number, double& result) {
  for (const Field& argument : arguments)
    if (!argument.is_constant()) return false;
  using Number = Jet<double, 1, 0>;
  std::array<Number, 3> numbers{};
  for (std::size_t i = 0; i < arguments.size(); ++i) numbers[i] = arguments[i].constant();
  result = apply_rule(operation, numbers[0], numbers[1], numbers[2], number).value();
  return std::isfinite(result);
}

bool is_finite_number(const Field& f) { return f.is_constant() && std::isfinite(f.constant()); }

Field unary(Operation operation, const Field& a) { return apply(operation, {a}); }

}  // namespace

Field::Field(double value) {
  auto node = std::make_shared<Node>();
  node->number = value;
  node->defined_everywhere = std::isfinite(value);
  node_ = std::move(node);
}

// Destroying a node destroys its arguments, which destroy theirs: unlinked here one by one instead.
// An argument that occurs twice has two handles; the one that is dropped last finds itself alone.
Field::Node::~Node() {
  std::vector<std::shared_ptr<const Node>> pending;
  const auto take = [&pending](std::vector<Field>& fields) {
    for (Field& field : fields) pending.push_back(std::move(field.node_));
    fields.clear();
  };
  take(arguments);
  while (!pending.empty()) {
    std::shared_ptr<const Node> node = std::move(pending.back());
    pending.pop_back();
    // Of a node that is an argument twice, or in use elsewhere, this is one handle of several.
    if (node.use_count() != 1) continue;
    // Sole owner: nobody else can see that its arguments are taken away. What other threads did
    // before they let go of it has happened.
    std::atomic_thread_fence(std::memory_order_acquire);
    take(const_cast<Node&>(*node).arguments);
  }
}

bool Field::is_constant() const { return node_->operation == Operation::constant; }
bool Field::is_constant(double value) const { return is_constant() && node_->number == value; }

double Field::constant() const {
  if (!is_constant()) throw InvalidArgument("the field is not a constant");
  return node_->number;
}

Field coordinate(int axis) {
  if (axis < 0 || axis > 3) throw InvalidArgument("coordinates are numbered 0 (x) to 3 (t)");
  return make(Operation::coordinate, {}, 0, axis);
}

Field parameter(int index, const std::string& name) {
  if (index < 0) throw InvalidArgument("parameters are numbered from 0");
  auto node = std::make_shared<Field::Node>();
  node->operation = Operation::parameter;
  node->index = index;
  if (!name.empty()) node->name = std::make_shared<const std::string>(name);
  return Field(std::shared_ptr<const Field::Node>(std::move(node)));
}

Field field(std::shared_ptr<const FieldSource> source) {
  if (!source) throw InvalidArgument("a field needs a source, got none");
  auto node = std::make_shared<Field::Node>();
  node->operation = Operation::source;
  node->source = std::move(source);
  node->defined_everywhere = false;
  return Field(std::shared_ptr<const Field::Node>(std::move(node)));
}

Field apply(Operation operation, std::vector<Field> arguments, std::optional<double> number) {
  const OperationRow* row = find_operation(operation);
  if (!row) throw InvalidArgument("this operation has a builder of its own");
  const std::string name(row->name);
  if (row->arity != static_cast<int>(arguments.size()))
    throw InvalidArgument(name + " takes " + std::to_string(row->arity) + " arguments, got " +
                          std::to_string(arguments.size()));
  if (number.has_value() != (row->numbers == 1))
    throw InvalidArgument(name +
                          (number ? " takes no number" : " needs a number beside its arguments"));
  if (number)
    if (const std::string expected = objection_to_number(operation, *number); !expected.empty())
      throw InvalidArgument(name + " needs " + expected + ", got " + std::to_string(*number));
  if (operation == Operation::power && is_finite_number(arguments[1]))
    return pow(arguments[0], arguments[1]);
  if (operation == Operation::integer_power && *number == 0) return 1.0;
  double value = 0;
  if (fold(operation, arguments, number.value_or(0), value)) return Field(value);
  const int index = operation == Operation::integer_power ? static_cast<int>(*number) : 0;
  return make(operation, std::move(arguments), number.value_or(0), index);
}

Field operator+(const Field& a, const Field& b) {
  if (a.is_constant(0)) return b;
  if (b.is_constant(0)) return a;
  return apply(Operation::add, {a, b});
}

Field operator-(const Field& a, const Field& b) {
  if (b.is_constant(0)) return a;
  if (a.is_constant(0)) return -b;
  return apply(Operation::subtract, {a, b});
}

Field operator*(const Field& a, const Field& b) {
  if (a.is_constant(0) && b.node().defined_everywhere) return 0.0;
  if (b.is_constant(0) && a.node().defined_everywhere) return 0.0;
  if (a.is_constant(1)) return b;
  if (b.is_constant(1)) return a;
  if (a.is_constant(-1)) return -b;
  if (b.is_constant(-1)) return -a;
  return apply(Operation::multiply, {a, b});
}

Field operator/(const Field& a, const Field& b) {
  if (b.is_constant(1)) return a;
  return apply(Operation::divide, {a, b});
}

Field product_or_nothing(const Field& a, const Field& b) {
  return a.is_constant(0) || b.is_constant(0) ? Field(0.0) : a * b;
}

Field operator-(const Field& a) {
  if (a.node().operation == Operation::negate) return a.node().arguments[0];
  return apply(Operation::negate, {a});
}

Field pow(const Field& a, const Field& b) {
  if (!is_finite_number(b)) return apply(Operation::power, {a, b});
  const double exponent = b.constant();
  if (exponent == 0) return 1.0;
  if (exponent == 1) return a;
  if (a.is_constant() && std::isfinite(std::pow(a.constant(), exponent)))
    return std::pow(a.constant(), exponent);
  const bool is_whole = exponent == std::floor(exponent) && std::fabs(exponent) <= 64;
  return apply(is_whole ? Operation::integer_power : Operation::real_power, {a}, exponent);
}

Field sqrt(const Field& a) { return unary(Operation::sqrt, a); }
Field cbrt(const Field& a) { return unary(Operation::cbrt, a); }
Field exp(const Field& a) { return unary(Operation::exp, a); }
Field log(const Field& a) { return unary(Operation::log, a); }
Field sin(const Field& a) { return unary(Operation::sin, a); }
Field cos(const Field& a) { return unary(Operation::cos, a); }
Field tan(const Field& a) { return unary(Operation::tan, a); }
Field asin(const Field& a) { return unary(Operation::asin, a); }
Field acos(const Field& a) { return unary(Operation::acos, a); }
Field atan(const Field& a) { return unary(Operation::atan, a); }
Field atan2(const Field& y, const Field& x) { return apply(Operation::atan2, {y, x}); }
Field sinh(const Field& a) { return unary(Operation::sinh, a); }
Field cosh(const Field& a) { return unary(Operation::cosh, a); }
Field tanh(const Field& a) { return unary(Operation::tanh, a); }
Field asinh(const Field& a) { return unary(Operation::asinh, a); }
Field erf(const Field& a) { return unary(Operation::erf, a); }
Field abs(const Field& a) { return unary(Operation::abs, a); }
Field sign(const Field& a) { return unary(Operation::sign, a); }
Field min(const Field& a, const Field& b) { return apply(Operation::min, {a, b}); }
Field max(const Field& a, const Field& b) { return apply(Operation::max, {a, b}); }
Field hypot(const Field& a, const Field& b) { return apply(Operation::hypot, {a, b}); }
Field step(const Field& a) { return unary(Operation::step, a); }
Field floor(const Field& a) { return unary(Operation::floor, a); }
Field mod(const Field& a, const Field& b) { return apply(Operation::mod, {a, b}); }

Field select(const Field& condition, const Field& yes, const Field& no) {
  if (condition.is_constant()) return condition.constant() != 0 ? yes : no;
  return apply(Operation::select, {condition, yes, no});
}

Field partial(const Field& f, int axis) {
  if (axis < 0) throw InvalidArgument("coordinates are numbered from 0");
  const Field::Node& node = f.node();
  switch (node.operation) {
    case Operation::constant:
      return std::isnan(node.number) ? f : Field(0.0);
    case Operation::parameter:
      return 0.0;
    case Operation::coordinate:
      return node.index == axis ? 1.0 : 0.0;
    default:
      return make(Operation::partial, {f}, 0, axis);
  }
}

Field partial(const Field& f, const MultiIndex& alpha) {
  Field derivative = f;
  for (int axis = 0; axis < maximum_variables; ++axis)
    for (int k = 0; k < alpha[axis]; ++k) derivative = partial(derivative, axis);
  return derivative;
}

std::vector<Field> gradient(const Field& f, int dimension) {
  std::vector<Field> components;
  for (int axis = 0; axis < dimension; ++axis) components.push_back(partial(f, axis));
  return components;
}

Field inward_derivative(const Field& f, const Field& omega, int dimension) {
  Field sum = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    sum = sum + product_or_nothing(partial(omega, axis), partial(f, axis));
  return sum;
}

Field laplacian(const Field& f, int dimension) {
  Field sum = 0.0;
  for (int axis = 0; axis < dimension; ++axis) sum = sum + partial(partial(f, axis), axis);
  return sum;
}

Field normalize(const Field& f, int dimension) {
  return f / sqrt(f * f + inward_derivative(f, f, dimension));
}

}  // namespace rfm
