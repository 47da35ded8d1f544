#include "problems/boundary_conditions.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <set>

#include "core/boolean_simplification.hpp"
#include "core/boundary_piece.hpp"
#include "core/r_functions.hpp"
#include "core/smooth_joints.hpp"
#include "core/tape.hpp"
#include "core/trim.hpp"
#include "problems/boundary_coverage.hpp"
#include "problems/result_scope.hpp"
#include "problems/solution_symbols.hpp"
#include "quadrature/candidate_boxes.hpp"
#include "solution_structures/transfinite.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

std::vector<std::string> data_keys(Condition::Kind kind) {
  switch (kind) {
    case Condition::Kind::value:
      return {};  // by unknown
    case Condition::Kind::flux:
      return {"flux"};
    case Condition::Kind::convection:
      return {"coefficient", "ambient"};
    case Condition::Kind::robin:
      return {"a", "b", "c"};
    case Condition::Kind::slope:
      return {"normal_derivative"};
    case Condition::Kind::oblique:
      return {"value", "direction.x", "direction.y", "direction.z"};
  }
  return {};
}

// Where `where` ≥ 0 and no claim of higher priority holds.
std::optional<Field> exclusive(const std::optional<Field>& where,
                               const std::vector<Field>& earlier) {
  std::optional<Field> result = where;
  for (const Field& claimed : earlier) result = result ? min(*result, -claimed) : -claimed;
  return result;
}

// The claims that hold something of a piece, up to the first that holds all of what is left.
std::vector<PieceClaim> settled(const PieceConditions& piece, int primitive,
                                const DomainRule& rule) {
  const double whole = rule.boundary_measure(primitive), negligible = 1e-9 * whole;
  std::vector<PieceClaim> claims;
  for (PieceClaim claim : piece.claims) {
    if (claim.chosen_by_geometry && claim.where) {
      const double part =
          integrate(step(*claim.where), rule, {Contribution::Place::boundary, {primitive}});
      if (part <= negligible) continue;
      if (part >= whole - negligible) claim.where.reset();
    }
    claims.push_back(claim);
    if (!claim.where) break;
  }
  return claims;
}

// A value condition, unknown by unknown.
void add_values(const Condition& condition, const std::vector<std::string>& unknowns,
                const ExpressionScope& scope, PieceCondition piece,
                std::vector<PieceCondition>& result) {
  for (std::size_t c = 0; c < unknowns.size(); ++c) {
    const auto value = condition.data.find(unknowns[c]);
    const bool is_free = value == condition.data.end() && !condition.clamped;
    piece.component = static_cast<int>(c);
    if (unknowns.size() > 1) piece.unknown = unknowns[c];
    piece.kind = is_free ? Condition::Kind::flux : Condition::Kind::value;
    if (is_free) piece.enforcement = Condition::Enforcement::automatic;
    piece.clamped = condition.clamped;
    piece.data = {is_free || condition.clamped ? Field(0.0) : value->second.field(scope)};
    for (const char* key : {"normal_derivative", "second_normal_derivative"})
      if (const auto derivative = condition.data.find(key); derivative != condition.data.end())
        piece.data.push_back(derivative->second.field(scope));
    result.push_back(piece);
  }
}

// The pieces that the structure prescribes, as a set of primitives.
using Primitives = std::set<int>;

// The conjuncts of the domain's expression whose primitives, as far as they bound the domain, are
// all in `prescribed` and in no other conjuncts, joined. (A circle of which the boundary has
// several arcs stands in several conjuncts: one of them vanishes on some of the arcs only.)
struct PrescribedConjuncts {
  BooleanExpression expression = BooleanExpression::constant(true);
  Primitives covered;
};

PrescribedConjuncts prescribed_conjuncts(const BooleanExpression& domain,
                                         const RegionEvaluator& region, const Box& bounds,
                                         const Primitives& bounding, const Primitives& prescribed) {
  const std::vector<BooleanExpression> all =
      conjuncts(without_redundancy(simplified(domain, region, bounds)));
  std::vector<Primitives> used;
  for (const BooleanExpression& conjunct : all) {
    Primitives& primitives = used.emplace_back();
    for (const auto& node : conjunct.nodes())
      if (node.kind == BooleanExpression::Kind::variable && bounding.contains(node.first))
        primitives.insert(node.first);
  }
  PrescribedConjuncts result{BooleanExpression::constant(true), prescribed};
  const auto is_covered = [&](const Primitives& primitives) {
    return std::ranges::includes(result.covered, primitives);
  };
  for (std::size_t before = result.covered.size() + 1; before != result.covered.size();) {
    before = result.covered.size();
    for (const Primitives& primitives : used)
      if (!is_covered(primitives))
        for (const int primitive : primitives) result.covered.erase(primitive);
  }
  Primitives found;
  for (std::size_t i = 0; i < all.size(); ++i) {
    if (used[i].empty() || !is_covered(used[i])) continue;
    result.expression = result.expression & all[i];
    found.insert(used[i].begin(), used[i].end());
  }
  result.covered = found;
  return result;
}

// A function that vanishes on the pieces of `primitives` (with their `where`) and nowhere else.
Weight vanishing_on(const std::vector<PieceCondition>& pieces, const RegionEvaluator& region,
                    const Box& bounds, const Primitives& bounding, const WeightOptions& options) {
  Primitives whole;
  for (const PieceCondition& piece : pieces)
    if (!piece.where) whole.insert(piece.primitive);
  const PrescribedConjuncts conjuncts =
      prescribed_conjuncts(region.region().expression(), region, bounds, bounding, whole);
  Weight result = weight(conjuncts.expression, region, bounds, options);
  for (const PieceCondition& piece : pieces) {
    if (!piece.where && conjuncts.covered.contains(piece.primitive)) continue;
    const BoundaryPiece part = boundary_piece(piece.primitive, region, bounds);
    const Field function =
        piece.where ? trim(part.function, *piece.where, bounds.longest_side()) : part.function;
    result.function = result.function * function;
    const std::string text = "trim(omega(" + piece.name + "))";
    result.formula += (result.formula.empty() ? "" : " * ") + text;
    result.parts.push_back(
        {text, "a piece trimmed to its part of the boundary", "twice differentiable off its ends"});
  }
  return result;
}

// Whether the whole boundary is prescribed piece by piece.
bool prescribe_all(const std::vector<PieceCondition>& pieces, const Primitives& bounding) {
  Primitives whole;
  for (const PieceCondition& piece : pieces)
    if (!piece.where) whole.insert(piece.primitive);
  return whole == bounding;
}

// γ / √(1 + (γ/L)²): keeps zeros and slopes of 1 there, and levels off at L.
Field levelled(const Field& gamma, double length) {
  return gamma / sqrt(1.0 + gamma * gamma / (length * length));
}

// How far from the pieces of one set of data: a product, so that it is smooth where pieces of the
// set meet. Factors level off at the size of the domain, or the distance of one set would be a
// product of large numbers where that of another is small, and the interpolant would change from
// one to the other within a thin layer.
struct DistanceFromPieces {
  Weight product{1.0, ""};
  std::optional<Field> nearest;
};
DistanceFromPieces distance_from(const std::vector<PieceCondition>& pieces,
                                 const BooleanExpression& domain, const RegionEvaluator& region,
                                 const Box& bounds, const Primitives& bounding) {
  const double length = 1.0 * bounds.longest_side();
  DistanceFromPieces distance;
  const auto multiply = [&](const Field& function, const std::string& formula) {
    distance.product.function = distance.product.function * (levelled(function, length) / length);
    distance.product.formula += (distance.product.formula.empty() ? "" : " * ") + formula;
    distance.nearest = distance.nearest ? conjunction(*distance.nearest, function) : function;
  };
  Primitives whole;
  for (const PieceCondition& piece : pieces)
    if (!piece.where) whole.insert(piece.primitive);
  const PrescribedConjuncts prescribed =
      prescribed_conjuncts(domain, region, bounds, bounding, whole);
  for (const Weight& factor : normalized_factors(prescribed.expression, region, bounds))
    multiply(factor.function, factor.formula);
  for (const PieceCondition& piece : pieces) {
    if (!piece.where && prescribed.covered.contains(piece.primitive)) continue;
    const BoundaryPiece part = boundary_piece(piece.primitive, region, bounds);
    multiply(piece.where ? trim(part.function, *piece.where, bounds.longest_side()) : part.function,
             "trim(omega(" + piece.name + "))");
  }
  return distance;
}

// Whether pieces with different data are parts of one curve or surface.
bool share_surfaces(const std::vector<PieceCondition>& pieces, const RegionEvaluator& region,
                    const Box& bounds) {
  const auto& primitives = region.region().primitives();
  for (const PieceCondition& a : pieces)
    for (const PieceCondition& b : pieces)
      if (a.primitive < b.primitive && !same_expression(a.data[0], b.data[0]) &&
          is_same_surface(region.level(a.primitive), region.level(b.primitive),
                          primitives[a.primitive]->level, primitives[b.primitive]->level, bounds))
        return true;
  return false;
}

// "a, b, c and 9 more".
std::string abridged(const std::vector<std::string>& names) {
  constexpr std::size_t most = 4;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most); ++i)
    text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most) text += " and " + std::to_string(names.size() - most) + " more";
  return text;
}

}  // namespace

std::vector<PieceCondition> piece_conditions(const Problem& problem, const RegionEvaluator& region,
                                             const std::vector<int>& bounding_primitives,
                                             const DomainRule& rule) {
  std::vector<std::string> names;
  for (int primitive : bounding_primitives)
    names.push_back(region.region().primitives()[primitive]->name);
  check_boundary_coverage(problem, names);
  std::vector<PieceCondition> result;
  const std::vector<PieceConditions> assigned = assign_conditions(problem, names);
  for (std::size_t i = 0; i < assigned.size(); ++i) {
    ExpressionScope scope = problem.scope;
    define_normal(scope, outward_normal(bounding_primitives[i], region));
    ExpressionScope natural_scope = scope;
    define_symbols(natural_scope, problem.physics.unknowns, problem.dimension);
    std::vector<Field> earlier;
    for (const PieceClaim& claim : settled(assigned[i], bounding_primitives[i], rule)) {
      const Condition& condition = problem.conditions[claim.condition];
      PieceCondition piece;
      piece.primitive = bounding_primitives[i];
      piece.name = names[i];
      piece.kind = condition.kind;
      piece.enforcement = condition.enforcement;
      piece.condition = claim.condition;
      piece.exponent = condition.exponent;
      piece.where = exclusive(claim.where, earlier);
      if (claim.where) earlier.push_back(*claim.where);
      for (const std::string& key : data_keys(condition.kind))
        if (const auto datum = condition.data.find(key); datum != condition.data.end())
          piece.data.push_back(datum->second.field(natural_scope));
      if (condition.kind == Condition::Kind::value)
        add_values(condition, problem.physics.unknowns, scope, piece, result);
      else
        result.push_back(std::move(piece));
    }
  }
  return result;
}

DirichletPlan plan_dirichlet(const std::vector<PieceCondition>& conditions,
                             const RegionEvaluator& region, const Box& bounds,
                             const WeightOptions& options, const std::vector<bool>& data_is_regular,
                             const std::optional<BooleanExpression>& regular_form) {
  DirichletPlan plan;
  using Enforcement = Condition::Enforcement;
  const Primitives joints = smooth_joints(region, bounds);
  const auto joins_smoothly = [&](int primitive) {
    return region.region().primitives()[primitive]->joins_smoothly || joints.contains(primitive);
  };
  Primitives bounding, candidates;
  for (const PieceCondition& piece : conditions) bounding.insert(piece.primitive);
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const PieceCondition& piece = conditions[i];
    if (piece.kind == Condition::Kind::value && !piece.where && data_is_regular[i] &&
        piece.enforcement != Enforcement::weak &&
        (!joins_smoothly(piece.primitive) || piece.enforcement == Enforcement::structure))
      candidates.insert(piece.primitive);
  }
  const Primitives covered =
      prescribed_conjuncts(region.region().expression(), region, bounds, bounding, candidates)
          .covered;
  std::map<std::string, std::vector<std::string>> weak_pieces;  // by reason
  for (std::size_t i = 0; i < conditions.size(); ++i) {
    const PieceCondition& piece = conditions[i];
    if (piece.kind != Condition::Kind::value) continue;
    const bool smooth = covered.contains(piece.primitive) && !piece.where && data_is_regular[i];
    if (piece.enforcement != Enforcement::weak &&
        (smooth || piece.enforcement == Enforcement::structure)) {
      plan.by_structure.push_back(piece);
      continue;
    }
    plan.weakly.push_back(piece);
    if (piece.enforcement == Enforcement::weak) continue;
    weak_pieces
        [!data_is_regular[i] ? "its data are not defined and smooth in the whole domain"
         : piece.where       ? "it covers a part of its piece, where a structure would lose order"
         : joins_smoothly(piece.primitive)
             ? "its piece goes on smoothly in another one, where a structure would lose order"
             : "it shares a corner of the boundary's expression with another kind of condition"]
            .push_back(piece.name);
  }
  for (const auto& [reason, pieces] : weak_pieces)
    plan.remarks.push_back("value at " + abridged(pieces) + " is enforced weakly: " + reason);
  if (plan.by_structure.empty()) return plan;
  if (regular_form && prescribe_all(plan.by_structure, bounding)) {
    plan.weight = weight(*regular_form, region, bounds, options);
    plan.remarks.emplace_back(
        "omega is made of an equal, shorter expression of the domain: shapes that share sides "
        "would make it rough, or zero inside");
    plan.uses_regular_form = true;
  } else {
    plan.weight = vanishing_on(plan.by_structure, region, bounds, bounding, options);
  }
  // Where slopes vanish, too, omega does so to the second order.
  std::vector<PieceCondition> clamped;
  std::ranges::copy_if(plan.by_structure, std::back_inserter(clamped), &PieceCondition::clamped);
  if (!clamped.empty()) {
    const Weight factor = clamped.size() == plan.by_structure.size()
                              ? plan.weight
                              : vanishing_on(clamped, region, bounds, bounding, options);
    plan.weight.function = plan.weight.function * factor.function;
    plan.weight.formula = "(" + plan.weight.formula + ") * (" + factor.formula + ")";
  }
  // Pieces with the same data are one set of the interpolant: where they meet it stays smooth.
  // Those where the slope of data is prescribed, too, are not one with others, unless all data are
  // equal.
  const auto have_same_data = [](const PieceCondition& a, const PieceCondition& b) {
    return same_expression(a.data[0], b.data[0]);
  };
  const bool all_same = std::ranges::all_of(plan.by_structure, [&](const PieceCondition& piece) {
    return have_same_data(piece, plan.by_structure[0]);
  });
  std::vector<std::vector<PieceCondition>> groups;
  for (const PieceCondition& piece : plan.by_structure) {
    const auto same = [&](const std::vector<PieceCondition>& group) {
      return have_same_data(group[0], piece) && (all_same || group[0].clamped == piece.clamped);
    };
    const auto group = std::ranges::find_if(groups, same);
    if (group == groups.end())
      groups.push_back({piece});
    else
      group->push_back(piece);
  }
  // Shapes that share sides would make distances zero inside, as they would omega. Where sides with
  // different data lie on one line, which is one in the shorter expression, they have to be
  // trimmed.
  const BooleanExpression& domain =
      plan.uses_regular_form && !share_surfaces(plan.by_structure, region, bounds)
          ? *regular_form
          : region.region().expression();
  std::vector<TransfiniteDatum> data;
  Structure::Call call{{}, "transfinite", {}};
  for (const auto& group : groups) {
    Weight distance{1.0, ""};
    if (groups.size() > 1)
      distance = distance_from(group, domain, region, bounds, bounding).product;
    const int exponent = group[0].clamped ? 2 : 1;
    data.push_back({group[0].data[0], distance.function, exponent});
    call.arguments.insert(call.arguments.end(),
                          {group[0].data[0], distance.function, double(exponent)});
    std::string pieces;
    for (const PieceCondition& piece : group) pieces += (pieces.empty() ? "" : ", ") + piece.name;
    plan.data_sets.push_back({pieces, distance.formula});
  }
  const DistanceFromPieces distance =
      distance_from(plan.by_structure, domain, region, bounds, bounding);
  plan.distance = distance.product.function;
  plan.nearest = distance.nearest.value_or(1.0);
  plan.data = transfinite_interpolant(data);
  plan.given = plan.data;
  if (groups.size() > 1) plan.given = plan.given.written_as(plan.data, call);
  return plan;
}

}  // namespace rfm
