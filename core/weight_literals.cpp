#include "core/weight_literals.hpp"

#include "core/error.hpp"
#include "core/expression_text.hpp"
#include "core/function_shaping.hpp"
#include "core/r_functions.hpp"

namespace rfm {

WeightLiterals::WeightLiterals(const Region& region, const WeightOptions& options)
    : region_(region), options_(options), scales_(region.primitives().size(), 1.0) {
  for (const PieceScale& scale : options.piece_scales) {
    if (!(scale.scale > 0))
      throw InvalidArgument("the scale of " + scale.name + " must be positive, got " +
                            std::to_string(scale.scale));
    for (const int primitive : named(scale.name)) scales_[primitive] = scale.scale;
  }
}

std::vector<int> WeightLiterals::named(const std::string& name) const {
  std::vector<int> found;
  for (std::size_t k = 0; k < region_.primitives().size(); ++k) {
    const std::string& own = region_.primitives()[k]->name;
    if (own == name || own.starts_with(name + ".")) found.push_back(static_cast<int>(k));
  }
  if (found.empty()) throw InvalidArgument("the region has no piece '" + name + "'");
  return found;
}

Field WeightLiterals::function(int primitive, bool negated) const {
  Field result = region_.primitives()[primitive]->function;
  if (negated) result = -result;
  if (scales_[primitive] != 1) result = result / scales_[primitive];
  if (options_.saturation) result = saturate(result, *options_.saturation);
  if (options_.cap) result = cap(result, *options_.cap);
  return result;
}

Field WeightLiterals::factor(int primitive, bool negated) const {
  if (!options_.plain()) return function(primitive, negated);
  const Field& level = region_.primitives()[primitive]->level;
  return negated ? -level : level;
}

std::string WeightLiterals::text(int primitive, bool negated) const {
  std::string result =
      (negated ? "-omega(" : "omega(") + region_.primitives()[primitive]->name + ")";
  if (scales_[primitive] != 1) result += "/" + number_text(scales_[primitive]);
  if (options_.saturation)
    result += "/(1 + abs(" + number_text(options_.saturation->beta) + "*(" + result + "))^" +
              number_text(options_.saturation->alpha) + ")";
  if (options_.cap)
    result = "r0_and(" + result + ", " +
             to_text(*options_.cap, {.parameters = {}, .names = {}, .abbreviated = true}) + ")";
  return result;
}

Field WeightLiterals::combined(const BooleanExpression& expression, const RSystem& system,
                               double size) const {
  const int count = static_cast<int>(region_.primitives().size());
  const BooleanExpression monotone = expression.monotone_form(count);
  std::vector<Field> literals(2 * region_.primitives().size());
  for (const auto& node : monotone.nodes())
    if (node.kind == BooleanExpression::Kind::variable)
      literals[node.first] = function(node.first % count, node.first >= count) / size;
  return size * r_function(monotone, literals, system);
}

std::string WeightLiterals::combined_text(const BooleanExpression& expression,
                                          const RSystem& system, double size) const {
  using Kind = BooleanExpression::Kind;
  const int count = static_cast<int>(region_.primitives().size());
  const BooleanExpression monotone = expression.monotone_form(count);
  std::vector<std::string> built;
  for (const auto& node : monotone.nodes()) {
    if (node.kind == Kind::constant)
      built.push_back(node.first ? "1" : "-1");
    else if (node.kind == Kind::variable)
      built.push_back(text(node.first % count, node.first >= count) +
                      (size == 1 ? "" : "/" + number_text(size)));
    else
      built.push_back(operation_text(system, node.kind == Kind::conjunction, built[node.first],
                                     built[node.second]));
  }
  return (size == 1 ? "" : number_text(size) + "*") + built.back();
}

}  // namespace rfm
