#include "core/graph_derivative.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/field_node.hpp"

namespace rfm {
namespace {

// `regular`, but 0 where `singular` is 0: derivatives that do not exist are finite by convention.
Field unless_zero(const Field& singular, const Field& regular) {
  return select(apply(Operation::equal, {singular, 0.0}), 0.0, regular);
}

// `derivative`, but no number where `f` is none.
Field where_defined(const Field& derivative, const Field& f) { return derivative + 0.0 * f; }

// f′ of f(a) for the operations of one argument; `f` is the node itself.
Field slope(Operation operation, const Field& f, const Field& a) {
  switch (operation) {
    case Operation::negate:
      return -1.0;
    case Operation::sqrt:
      return unless_zero(a, 0.5 / f);
    case Operation::cbrt:
      return unless_zero(a, f / (3.0 * a));
    case Operation::exp:
      return f;
    case Operation::log:
      return where_defined(1.0 / a, f);
    case Operation::sin:
      return cos(a);
    case Operation::cos:
      return -sin(a);
    case Operation::tan:
      return 1.0 + f * f;
    case Operation::asin:
    case Operation::acos: {
      const Field rest = (1.0 - a) * (1.0 + a), inverse = unless_zero(rest, 1.0 / sqrt(rest));
      return operation == Operation::asin ? inverse : -inverse;
    }
    case Operation::atan:
      return 1.0 / (1.0 + a * a);
    case Operation::sinh:
      return cosh(a);
    case Operation::cosh:
      return sinh(a);
    case Operation::tanh:
      return 1.0 - f * f;
    case Operation::asinh:
      return 1.0 / sqrt(1.0 + a * a);
    case Operation::erf:
      return 2 * std::numbers::inv_sqrtpi * exp(-(a * a));
    case Operation::abs:
      return select(apply(Operation::less, {a, 0.0}), -1.0, 1.0);
    case Operation::sign:
    case Operation::step:
    case Operation::floor:
      return where_defined(0.0, f);
    default:
      throw InvalidArgument("no derivative is known of the operation " +
                            std::string(find_operation(operation)->name));
  }
}

// R₀-functions v = a + b ∓ s: ∂v/∂a = (b − v)/±s, which does not cancel; 1 where a = b = 0.
Field r0_derivative(const Field& v, const Field& a, const Field& b, const Field& da,
                    const Field& db, bool conjunction) {
  const Field s = hypot(a, b), corner = apply(Operation::equal, {s, 0.0});
  const auto weight = [&](const Field& other) {
    return select(corner, 1.0, (conjunction ? other - v : v - other) / s);
  };
  return weight(b) * da + weight(a) * db;
}

// ∂f of the other R-functions of two arguments, which have the constant n.
Field r_derivative(Operation operation, double n, const Field& a, const Field& b, const Field& da,
                   const Field& db) {
  const auto norm = [&] { return pow(pow(abs(a), n) + pow(abs(b), n), 1 / n); };
  switch (operation) {
    case Operation::ralpha_conjunction:
    case Operation::ralpha_disjunction: {
      const Field root =
          hypot(std::sqrt(0.5 * (1 + n)) * (a - b), std::sqrt(0.5 * (1 - n)) * (a + b));
      const Field bent = unless_zero(root, ((a - n * b) * da + (b - n * a) * db) / root);
      const Field sum = da + db;
      return (operation == Operation::ralpha_conjunction ? sum - bent : sum + bent) / (1 + n);
    }
    case Operation::rp_conjunction:
    case Operation::rp_disjunction: {
      const Field size = norm();
      const Field bent = unless_zero(size, pow(a / size, n - 1) * da + pow(b / size, n - 1) * db);
      return operation == Operation::rp_conjunction ? da + db - bent : da + db + bent;
    }
    case Operation::rp_equivalence: {
      const Field size = norm();
      return unless_zero(
          size, b * pow(abs(b) / size, n) / size * da + a * pow(abs(a) / size, n) / size * db);
    }
    default:
      throw InvalidArgument("no derivative is known of the operation " +
                            std::string(find_operation(operation)->name));
  }
}

// ∂f of the operations of two arguments.
Field derivative(Operation operation, double number, const Field& f, const Field& a, const Field& b,
                 const Field& da, const Field& db) {
  switch (operation) {
    case Operation::add:
      return da + db;
    case Operation::subtract:
      return da - db;
    case Operation::multiply:
      return (da.is_constant(0) ? da : da * b) + (db.is_constant(0) ? db : a * db);
    case Operation::divide:
      return (da - f * db) / b;
    case Operation::power:
      return select(apply(Operation::equal, {a, 0.0}),
                    select(apply(Operation::equal, {b, 1.0}), da, 0.0 * f),
                    f * (product_or_nothing(db, log(a)) + b * da / a));
    case Operation::atan2: {
      const Field square = a * a + b * b;
      return unless_zero(square, (b * da - a * db) / square);
    }
    case Operation::min:
      return select(apply(Operation::less, {b, a}), db, da);
    case Operation::max:
      return select(apply(Operation::less, {a, b}), db, da);
    case Operation::hypot:
      return unless_zero(f, (a * da + b * db) / f);
    case Operation::mod:
      return da - floor(a / b) * db;
    case Operation::less:
    case Operation::less_equal:
    case Operation::equal:
      return where_defined(0.0, f);
    case Operation::r0_conjunction:
      return r0_derivative(f, a, b, da, db, true);
    case Operation::r0_disjunction:
      return r0_derivative(f, a, b, da, db, false);
    case Operation::r0_exclusive_or: {
      const Field root = sqrt(0.75 * (a - b) * (a - b) + 0.25 * (a + b) * (a + b));
      return unless_zero(
          root, ((2 * a - b) * da + (2 * b - a) * db) / root - 2 * (a * da + b * db) / hypot(a, b));
    }
    default:
      return r_derivative(operation, number, a, b, da, db);
  }
}

}  // namespace

GraphDerivative::GraphDerivative(const Field& variable) : variable_(variable) {
  const Operation operation = variable.node().operation;
  if (operation != Operation::coordinate && operation != Operation::parameter)
    throw InvalidArgument("derivatives are with respect to a coordinate or a parameter");
}

Field GraphDerivative::of_node(const Field& f) const {
  const Field::Node& node = f.node();
  const std::vector<Field>& arguments = node.arguments;
  switch (node.operation) {
    case Operation::constant:
      return 0.0;
    case Operation::coordinate:
    case Operation::parameter:
      return node.operation == variable_.node().operation && node.index == variable_.node().index
                 ? 1.0
                 : 0.0;
    case Operation::source:
      return of_source(f);
    default:
      break;
  }
  bool depends = false;
  for (const Field& argument : arguments) depends = depends || !known(argument).is_constant(0);
  if (!depends) return 0.0;
  const Field &a = arguments[0], &da = known(a);
  switch (node.operation) {
    case Operation::partial:
      return partial(da, node.index);
    case Operation::integer_power:
      return node.number * pow(a, node.number - 1) * da;
    case Operation::real_power: {
      const Field power = node.number * pow(a, node.number - 1);
      return (node.number >= 1 || node.number < 0 ? power : unless_zero(a, power)) * da;
    }
    case Operation::select:
      return select(a, known(arguments[1]), known(arguments[2]));
    default:
      break;
  }
  if (arguments.size() == 1) return slope(node.operation, f, a) * da;
  return derivative(node.operation, node.number, f, a, arguments[1], da, known(arguments[1]));
}

// The chain rule: Σᵢ (∂^{α+eᵢ} s)(place) ∂placeᵢ.
Field GraphDerivative::of_source(const Field& f) const {
  const Field::Node& node = f.node();
  std::vector<Field> place = node.arguments, slopes;
  for (const Field& argument : place) slopes.push_back(known(argument));
  if (place.empty())
    for (int axis = 0; axis < node.source->valid().dimension; ++axis) {
      place.push_back(coordinate(axis));
      slopes.push_back(of_node(place.back()));
    }
  Field sum = 0.0;
  for (std::size_t axis = 0; axis < place.size(); ++axis)
    if (!slopes[axis].is_constant(0))
      sum = sum + field_at(node.source, place,
                           source_derivative(node.index) + unit_index(static_cast<int>(axis))) *
                      slopes[axis];
  return sum;
}

Field GraphDerivative::of(const Field& f) {
  std::vector<Field> pending{f};
  while (!pending.empty()) {
    const Field field = pending.back();
    if (known_.contains(&field.node())) {
      pending.pop_back();
      continue;
    }
    bool ready = true;
    for (const Field& argument : field.node().arguments)
      if (!known_.contains(&argument.node())) {
        pending.push_back(argument);
        ready = false;
      }
    if (!ready) continue;
    pending.pop_back();
    known_.emplace(&field.node(), Known{field, of_node(field)});
  }
  return known(f);
}

Field derivative_with_respect_to(const Field& f, const Field& variable) {
  return GraphDerivative(variable).of(f);
}

}  // namespace rfm
