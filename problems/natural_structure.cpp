#include "problems/natural_structure.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/boundary_piece.hpp"
#include "core/error.hpp"
#include "core/normalization_length.hpp"
#include "core/trim.hpp"
#include "problems/regular_data.hpp"
#include "problems/structure_language.hpp"
#include "quadrature/vertices.hpp"
#include "solution_structures/condition_part.hpp"
#include "solution_structures/normal_conditions.hpp"
#include "solvers/form_symbols.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// Narrower ones are not resolved by rules, wider ones are nearly dependent on w.
constexpr double correction_cells = 1.5;

// Why no structure has a condition, or nothing.
std::string objection(const PieceCondition& condition, const Problem& problem,
                      const ScalarCoefficients& coefficients, const RegionEvaluator& region,
                      const Box& bounds) {
  if (problem.discretization.basis != Discretization::Basis::bspline)
    return "its corrections near the boundary need splines";
  if (depend_on_solution(coefficients) || std::ranges::any_of(condition.data, has_symbols))
    return "it depends on the solution";
  if (!problem.physics.materials.empty())
    return "the coefficients jump between materials, and so would u";
  const auto is_smooth = [&](const Field& f) {
    return f.is_constant() || is_regular(f, region, bounds);
  };
  if (!std::ranges::all_of(condition.data, is_smooth) ||
      !std::ranges::all_of(coefficients.conductivity, is_smooth))
    return "its data are not defined and smooth in the whole domain";
  return {};
}

// By how much w misses the condition. The data are for the outward normal; −∇ω is that on the
// piece, and has no singular points inside as its unit vector has.
Structure excess(const Structure& w, const NaturalPiece& piece,
                 const ScalarCoefficients& coefficients, const Box& bounds) {
  const int dimension = bounds.dimension;
  const std::vector<Field>& data = piece.condition.data;
  const Field& k = coefficients.conductivity[0];
  if (piece.condition.kind == Condition::Kind::oblique)
    return oblique_excess(w, piece.omega,
                          {{data.begin() + 1, data.end()}, 0.0, data[0], bounds.longest_side()});
  if (is_isotropic(coefficients, dimension)) {
    switch (piece.condition.kind) {
      case Condition::Kind::convection:
        return robin_excess(w, piece.omega, {data[0], k, data[0] * data[1]}, dimension);
      case Condition::Kind::robin:
        return robin_excess(w, piece.omega, {data[0], data[1], data[2]}, dimension);
      default:
        return normal_derivative_excess(w, piece.omega, data[0] / k, dimension);
    }
  }
  const Field normal_potential = -piece.omega;
  ObliqueData oblique{conductive_flux(coefficients, normal_potential, dimension), 0.0, 0.0,
                      bounds.longest_side()};
  if (piece.condition.kind == Condition::Kind::convection) {
    oblique.a = data[0];
    oblique.c = data[0] * data[1];
  } else {
    oblique.c = data[0];
  }
  return oblique_excess(w, piece.omega, oblique);
}

// Shapes given by expressions are as steep as these.
bool has_unit_slope(const Field& omega, int primitive, const DomainRule& rule) {
  constexpr double rounding = 1e-6;
  Field square = 0.0;
  for (int axis = 0; axis < rule.dimension(); ++axis)
    square = square + pow(partial(omega, axis), 2);
  const Field off = step(abs(square - 1.0) - rounding);
  return !(maximum(off, rule, {Contribution::Place::boundary, {primitive}}) > 0);
}

}  // namespace

std::vector<NaturalPiece> natural_pieces(const std::vector<PieceCondition>& conditions,
                                         const Problem& problem,
                                         const ScalarCoefficients& coefficients,
                                         const RegionEvaluator& region, const Box& bounds,
                                         const DomainRule& rule) {
  std::vector<NaturalPiece> pieces;
  for (const PieceCondition& condition : conditions) {
    if (condition.kind == Condition::Kind::value ||
        condition.enforcement != Condition::Enforcement::structure)
      continue;
    if (const std::string reason = objection(condition, problem, coefficients, region, bounds);
        !reason.empty())
      throw ProblemFileErrors(
          {Mistake{fmt::format("the condition at '{}' cannot be enforced by structure: {}",
                               condition.name, reason),
                   problem.conditions[condition.condition].place}});
    const BoundaryPiece piece = boundary_piece(condition.primitive, region, bounds);
    Field omega = piece.from_inside;
    if (piece.whole && !has_unit_slope(omega, condition.primitive, rule))
      omega = normalize_within(omega, bounds.longest_side(), bounds.dimension);
    if (condition.where) omega = trim_from_inside(omega, *condition.where, bounds.longest_side());
    pieces.push_back({condition, omega});
  }
  return pieces;
}

NaturalStructure with_natural_conditions(const Structure& w,
                                         const std::optional<PrescribedValues>& values,
                                         const std::vector<NaturalPiece>& pieces,
                                         const ScalarCoefficients& coefficients, const Box& bounds,
                                         const CellSides& cell, int remainder) {
  NaturalStructure result;
  std::vector<NaturalPart> parts;
  for (const NaturalPiece& piece : pieces) {
    const Field near = faded(piece.omega, correction_cells, cell);
    result.calls.push_back({near, "near", {piece.omega, correction_cells}});
    parts.push_back({excess(w, piece, coefficients, bounds), piece.omega, near});
  }
  result.structure = corrected(w, parts, Structure::undetermined(remainder), values);
  return result;
}

std::vector<Grading> natural_gradings(const std::vector<NaturalPiece>& pieces,
                                      const RegionEvaluator& region, const Box& bounds) {
  constexpr int levels = 15;
  std::vector<Grading> gradings;
  if (pieces.empty() || bounds.dimension != 2) return gradings;
  const auto is_corrected = [&](int primitive) {
    return std::ranges::any_of(
        pieces, [&](const NaturalPiece& piece) { return piece.condition.primitive == primitive; });
  };
  for (const Vertex& corner : find_vertices(region, bounds).vertices)
    if (std::ranges::any_of(corner.primitives, is_corrected))
      gradings.push_back({corner.point, corner.point, levels});
  for (const NaturalPiece& piece : pieces)
    if (piece.condition.where)
      gradings.push_back(towards_curve(
          {region.region().primitives()[piece.condition.primitive]->level, *piece.condition.where},
          2, levels));
  return gradings;
}

}  // namespace rfm
