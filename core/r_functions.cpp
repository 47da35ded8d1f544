#include "core/r_functions.hpp"

#include <vector>

#include "core/error.hpp"

namespace rfm {
namespace {

Field conjunction_alpha(const Field& x, const Field& y, double alpha) {
  if (!(alpha > -1 && alpha <= 1))
    throw InvalidArgument("R-alpha functions need -1 < alpha <= 1, got " + std::to_string(alpha));
  if (alpha == 0) return apply(Operation::r0_conjunction, {x, y});
  if (alpha == 1) return min(x, y);
  return apply(Operation::ralpha_conjunction, {x, y}, alpha);
}

Field conjunction_p(const Field& x, const Field& y, int p) {
  if (p < 2 || p % 2 != 0)
    throw InvalidArgument("R-p functions need an even p >= 2, got " + std::to_string(p));
  if (p == 2) return apply(Operation::r0_conjunction, {x, y});
  return apply(Operation::rp_conjunction, {x, y}, p);
}

}  // namespace

Field conjunction(const Field& x, const Field& y, const RSystem& system) {
  if (const auto* rp = std::get_if<Rp>(&system)) return conjunction_p(x, y, rp->p);
  return conjunction_alpha(x, y, std::get<RAlpha>(system).alpha);
}

Field disjunction(const Field& x, const Field& y, const RSystem& system) {
  if (const auto* alpha = std::get_if<RAlpha>(&system); alpha && alpha->alpha == 0)
    return apply(Operation::r0_disjunction, {x, y});
  return -conjunction(-x, -y, system);
}

Field implicit(const BooleanExpression& expression, const Region& region, const RSystem& system) {
  using Kind = BooleanExpression::Kind;
  std::vector<Field> built;
  for (const auto& node : expression.nodes()) {
    switch (node.kind) {
      case Kind::constant:
        built.push_back(node.first ? 1.0 : -1.0);
        break;
      case Kind::variable:
        built.push_back(region.primitives()[node.first]->function);
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

Field implicit(const Region& region, const RSystem& system) {
  return implicit(region.expression().negations_at_leaves(), region, system);
}

}  // namespace rfm
