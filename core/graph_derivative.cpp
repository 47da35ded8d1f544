#include "core/graph_derivative.hpp"

#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "core/field_node.hpp"

namespace rfm {
namespace {

Field less(const Field& a, const Field& b) { return apply(Operation::less, {a, b}); }

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
      // 1 − a² is as accurate next to ±1 as the slope is conditioned there, and so is its own
      // slope.
      const Field rest = 1.0 - a * a, inverse = unless_zero(rest, 1.0 / sqrt(rest));
      return operation == Operation::asin ? inverse : -inverse;
    }
    case Operation::atan:
      return 1.0 / (1.0 + a * a);
    case Operation::sinh:
      return cosh(a);
    case Operation::cosh:
      return sinh(a);
    case Operation::tanh:
      // Far out the hyperbolic cosine overflows.
      return select(less(abs(a), 20), pow(1.0 / cosh(a), 2.0), 4.0 * exp(-2.0 * abs(a)));
    case Operation::asinh:
      return 1.0 / hypot(1.0, a);
    case Operation::erf:
      return 2 * std::numbers::inv_sqrtpi * exp(-(a * a));
    case Operation::abs:
      return select(less(a, 0.0), -1.0, 1.0);
    case Operation::sign:
    case Operation::step:
    case Operation::floor:
      return where_defined(0.0, f);
    default:
      throw InvalidArgument("no derivative is known of the operation " +
                            std::string(find_operation(operation)->name));
  }
}

// aⁿ⁻¹; what the rounding of n − 1 loses is made up for.
Field lowered_power(const Field& a, double n) {
  const double lowered = n - 1, back = lowered - n;
  const double lost = (n - (lowered - back)) + (-1 - back);
  const Field power = pow(a, lowered);
  return lost == 0 ? power : select(less(0.0, a), power + power * (lost * log(a)), power);
}

// R₀-functions a + b ∓ s: ∂/∂a = 1 ∓ a/s, which where a is the larger is b² / (s (s ± a)); 1 where
// a = b = 0.
Field r0_derivative(const Field& a, const Field& b, const Field& da, const Field& db,
                    bool conjunction) {
  const Field s = hypot(a, b), corner = apply(Operation::equal, {s, 0.0});
  const auto weight = [&](const Field& own, const Field& other) {
    const Field unit = conjunction ? own / s : -(own / s);
    const Field small = pow(other / s, 2.0) / (1.0 + unit);
    return select(corner, 1.0, select(less(0.5, unit), small, 1.0 - unit));
  };
  return weight(a, b) * da + weight(b, a) * db;
}

// ∂f of the other R-functions of two arguments, which have the constant n.
Field r_derivative(Operation operation, double n, const Field& a, const Field& b, const Field& da,
                   const Field& db) {
  // The p-norm is L (1 + r)^{1/n}, r = (S/L)ⁿ, L the larger of |a| and |b|, S the smaller.
  const Field size_a = abs(a), size_b = abs(b), first = less(size_b, size_a);
  const Field larger = select(first, size_a, size_b), smaller = select(first, size_b, size_a);
  const Field sum = 1.0 + pow(smaller / larger, n);
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
      const Field terms = pow(a / larger, n - 1) * da + pow(b / larger, n - 1) * db;
      const Field bent = unless_zero(larger, terms * pow(sum, 1 / n - 1));
      return operation == Operation::rp_conjunction ? da + db - bent : da + db + bent;
    }
    case Operation::rp_equivalence: {
      const auto weight = [&](const Field& other, const Field& size) {
        return other / larger * pow(size / larger, n);
      };
      return unless_zero(larger,
                         (weight(b, size_b) * da + weight(a, size_a) * db) * pow(sum, -1 / n - 1));
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
      return (db.is_constant(0) ? da : da - f * db) / b;
    case Operation::power:
      return select(apply(Operation::equal, {a, 0.0}),
                    select(apply(Operation::equal, {b, 1.0}), da, 0.0 * f),
                    f * (product_or_nothing(db, log(a)) + b * da / a));
    case Operation::atan2: {
      const Field size = hypot(a, b);
      return unless_zero(size, (b / size * da - a / size * db) / size);
    }
    case Operation::min:
      return select(less(b, a), db, da);
    case Operation::max:
      return select(less(a, b), db, da);
    case Operation::hypot:
      return unless_zero(f, a / f * da + b / f * db);
    case Operation::mod:
      return da - floor((a - f) / b + 0.5) * db;  // a / b itself may round to another number
    case Operation::less:
    case Operation::less_equal:
    case Operation::equal:
      return where_defined(0.0, f);
    case Operation::r0_conjunction:
      return r0_derivative(a, b, da, db, true);
    case Operation::r0_disjunction:
      return r0_derivative(a, b, da, db, false);
    case Operation::r0_exclusive_or: {
      const Field size = hypot(a, b), root = hypot(std::sqrt(0.75) * (a - b), 0.5 * (a + b));
      const auto slope = [&](const Field& own, const Field& other) {
        return (2 * own - other) / root - 2 * (own / size);
      };
      return unless_zero(root, slope(a, b) * da + slope(b, a) * db);
    }
    default:
      return r_derivative(operation, number, a, b, da, db);
  }
}

// Whether ∂f as written above is f times something, or contains 0 f: no number where f is none.
bool has_factor_of_value(Operation operation) {
  switch (operation) {
    case Operation::power:
    case Operation::exp:
    case Operation::log:
    case Operation::sign:
    case Operation::step:
    case Operation::floor:
    case Operation::less:
    case Operation::less_equal:
    case Operation::equal:
      return true;
    default:
      return false;
  }
}

}  // namespace

GraphDerivative::GraphDerivative(const Field& variable) : variable_(variable) {
  const Operation operation = variable.node().operation;
  if (operation != Operation::coordinate && operation != Operation::parameter)
    throw InvalidArgument("derivatives are with respect to a coordinate or a parameter");
}

GraphDerivative::Known GraphDerivative::of_node(const Field& f) const {
  const Field::Node& node = f.node();
  const std::vector<Field>& arguments = node.arguments;
  const bool has_value = node.defined_everywhere;
  const auto zero = [](const Field& g) { return g.is_constant(0); };
  bool depends = false;
  for (const Field& argument : arguments) depends = depends || !zero(known(argument).derivative);
  switch (node.operation) {
    case Operation::constant:
      return {f, std::isnan(node.number) ? f : Field(0.0), has_value};
    case Operation::coordinate:
    case Operation::parameter: {
      const Field::Node& variable = variable_.node();
      const bool same = node.operation == variable.operation && node.index == variable.index;
      return {f, same ? 1.0 : 0.0, true};
    }
    case Operation::source: {
      const Field derivative = of_source(f);
      return {f, derivative, !zero(derivative)};
    }
    default:
      break;
  }
  if (!depends) return {f, 0.0, has_value};
  const auto& [a, da, a_tells] = known(arguments[0]);
  switch (node.operation) {
    case Operation::partial:
      return {f, partial(da, node.index), has_value};
    case Operation::integer_power:
      return {f, node.number * pow(a, node.number - 1) * da, a_tells};
    case Operation::real_power: {
      const Field power = node.number * lowered_power(a, node.number);
      const bool regular = node.number >= 1 || node.number < 0;
      return {f, (regular ? power : unless_zero(a, power)) * da, a_tells};
    }
    case Operation::select: {
      const Known &yes = known(arguments[1]), &no = known(arguments[2]);
      return {f, select(a, yes.derivative, no.derivative), yes.tells && no.tells};
    }
    default:
      break;
  }
  bool tells = has_factor_of_value(node.operation);
  if (arguments.size() == 1) return {f, slope(node.operation, f, a) * da, tells || a_tells};
  const auto& [b, db, b_tells] = known(arguments[1]);
  const bool product = node.operation == Operation::multiply;  // a is a factor of db, b of da
  // A quotient occurs in its derivative unless its divisor is fixed, which then divides that of a.
  if (node.operation == Operation::divide) tells = zero(db) ? a_tells : true;
  const bool of_a = a_tells || (product && !zero(db)), of_b = b_tells || (product && !zero(da));
  return {f, derivative(node.operation, node.number, f, a, b, da, db), tells || (of_a && of_b)};
}

// The chain rule: Σᵢ (∂^{α+eᵢ} s)(place) ∂placeᵢ.
Field GraphDerivative::of_source(const Field& f) const {
  const Field::Node& node = f.node();
  std::vector<Field> place = node.arguments, slopes;
  for (const Field& argument : place) slopes.push_back(known(argument).derivative);
  if (place.empty())
    for (int axis = 0; axis < node.source->valid().dimension; ++axis) {
      place.push_back(coordinate(axis));
      slopes.push_back(of_node(place.back()).derivative);
    }
  Field sum = 0.0;
  for (std::size_t axis = 0; axis < place.size(); ++axis)
    if (!slopes[axis].is_constant(0))
      sum = sum + field_at(node.source, place,
                           source_derivative(node.index) + unit_index(static_cast<int>(axis))) *
                      slopes[axis];
  return sum;
}

const GraphDerivative::Known& GraphDerivative::find(const Field& f) {
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
    known_.emplace(&field.node(), of_node(field));
  }
  return known(f);
}

Field GraphDerivative::of(const Field& f) {
  const auto& [node, derivative, tells] = find(f);
  return tells ? derivative : rfm::where_defined(derivative, f);
}

Field GraphDerivative::where_defined(const Field& f) { return find(f).derivative; }

Field derivative_with_respect_to(const Field& f, const Field& variable) {
  return GraphDerivative(variable).of(f);
}

}  // namespace rfm
