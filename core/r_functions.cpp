#include "core/r_functions.hpp"

#include <string>

#include "core/boolean_simplification.hpp"
#include "core/error.hpp"

namespace rfm {
namespace {

void require_order(int m) {
  if (m < 1 || m > 16)
    throw InvalidArgument("the order m of a system of R-functions is 1 to 16, got " +
                          std::to_string(m));
}

// |f|ⁿ.
Field absolute_power(const Field& f, int n) {
  return n % 2 == 0 ? pow(f, n) : abs(f) * pow(f, n - 1);
}

struct Conjunction {
  const Field &x, &y;

  Field operator()(const RAlpha& system) const {
    if (system.alpha == 0) return apply(Operation::r0_conjunction, {x, y});
    if (system.alpha == 1) return min(x, y);
    return apply(Operation::ralpha_conjunction, {x, y}, system.alpha);
  }
  Field operator()(const R1&) const { return min(x, y); }
  Field operator()(const Rp& system) const {
    if (system.p == 2) return apply(Operation::r0_conjunction, {x, y});
    return apply(Operation::rp_conjunction, {x, y}, system.p);
  }
  Field operator()(const RAlphaField& system) const {
    const Field& alpha = system.alpha;
    if (alpha.is_constant()) return (*this)(RAlpha{alpha.constant()});
    // x² + y² − 2αxy as a sum of squares, of x and y over their length: squares of themselves may
    // be out of range. Next to the boundary the difference cancels, its other form does not.
    const Field sum = x + y, length = hypot(x, y);
    const auto square_of = [&](const Field& f) { return pow(f / length, 2); };
    const Field root = select(
        apply(Operation::less, {0.0, length}),
        length * sqrt(0.5 * (1 + alpha) * square_of(x - y) + 0.5 * (1 - alpha) * square_of(sum)),
        length);
    return select(apply(Operation::less, {0.0, sum}), 2 * x * (y / (sum + root)),
                  (sum - root) / (1 + alpha));
  }
  Field operator()(const RAlphaM& system) const {
    require_order(system.m);
    return (*this)(RAlpha{system.alpha}) * pow(x * x + y * y, 0.5 * system.m);
  }
  Field operator()(const RCm& system) const {
    require_order(system.m);
    if (system.m == 1) return min(x, y);
    // sᵐ − eᵐ = (s − e)(s^{m−1} + … + e^{m−1}), and s − e = min(x, y).
    const Field s = 0.5 * (x + y), e = abs(0.5 * (x - y));
    Field quotient = 0.0;
    for (int k = 0; k < system.m; ++k) quotient = quotient + pow(s, k) * pow(e, system.m - 1 - k);
    return select(apply(Operation::less, {0.0, s}), min(x, y) * quotient,
                  -absolute_power(s, system.m) - pow(e, system.m));
  }
  Field operator()(const UserSystem& system) const {
    if (!system.conjunction)
      throw InvalidArgument("the system '" + system.name + "' has no conjunction");
    return system.conjunction(x, y);
  }
};

template <class Join>
Field balanced(const std::vector<Field>& fields, double of_none, const Join& join) {
  if (fields.empty()) return of_none;
  std::vector<Field> level = fields;
  while (level.size() > 1) {
    std::vector<Field> next;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2)
      next.push_back(join(level[i], level[i + 1]));
    if (level.size() % 2 == 1) next.push_back(level.back());
    level = std::move(next);
  }
  return level[0];
}

}  // namespace

Field conjunction(const Field& x, const Field& y, const RSystem& system) {
  return std::visit(Conjunction{x, y}, system);
}

Field disjunction(const Field& x, const Field& y, const RSystem& system) {
  if (const auto* alpha = std::get_if<RAlpha>(&system); alpha && alpha->alpha == 0)
    return apply(Operation::r0_disjunction, {x, y});
  if (std::holds_alternative<R1>(system)) return max(x, y);
  if (const auto* user = std::get_if<UserSystem>(&system); user && user->disjunction)
    return user->disjunction(x, y);
  return -conjunction(-x, -y, system);
}

Field negation(const Field& x) { return -x; }

Field exclusive_or(const Field& x, const Field& y, const RSystem& system) {
  if (const auto* alpha = std::get_if<RAlpha>(&system); alpha && alpha->alpha == 0)
    return apply(Operation::r0_exclusive_or, {x, y});
  return disjunction(conjunction(-x, y, system), conjunction(x, -y, system), system);
}

Field implication(const Field& x, const Field& y, const RSystem& system) {
  return disjunction(-x, y, system);
}

Field sheffer_stroke(const Field& x, const Field& y, const RSystem& system) {
  return -conjunction(x, y, system);
}

Field conjunction(const std::vector<Field>& fields, const RSystem& system) {
  conjunction(0.5, 0.5, system);  // throws, also where nothing is joined
  return balanced(fields, 1.0,
                  [&](const Field& a, const Field& b) { return conjunction(a, b, system); });
}

Field disjunction(const std::vector<Field>& fields, const RSystem& system) {
  disjunction(0.5, 0.5, system);
  return balanced(fields, -1.0,
                  [&](const Field& a, const Field& b) { return disjunction(a, b, system); });
}

Field r_function(const BooleanExpression& expression, std::span<const Field> arguments,
                 const RSystem& system) {
  if (expression.variable_count() > static_cast<int>(arguments.size()))
    throw InvalidArgument("a Boolean expression of " + std::to_string(expression.variable_count()) +
                          " variables needs as many fields, got " +
                          std::to_string(arguments.size()));
  using Kind = BooleanExpression::Kind;
  std::vector<Field> built;
  for (const auto& node : expression.nodes()) {
    switch (node.kind) {
      case Kind::constant:
        built.push_back(node.first ? 1.0 : -1.0);
        break;
      case Kind::variable:
        built.push_back(arguments[node.first]);
        break;
      case Kind::negation:
        built.push_back(-built[node.first]);
        break;
      case Kind::conjunction:
        built.push_back(conjunction(built[node.first], built[node.second], system));
        break;
      case Kind::disjunction:
        built.push_back(disjunction(built[node.first], built[node.second], system));
        break;
    }
  }
  return built.back();
}

Field implicit(const BooleanExpression& expression, const Region& region, const RSystem& system) {
  std::vector<Field> functions;
  for (const auto& primitive : region.primitives()) functions.push_back(primitive->function);
  return r_function(expression, functions, system);
}

Field implicit(const Region& region, const RSystem& system) {
  return implicit(without_redundancy(region.expression()), region, system);
}

}  // namespace rfm
