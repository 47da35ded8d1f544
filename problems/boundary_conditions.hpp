#pragma once

#include <optional>
#include <vector>

#include "core/boundary_piece.hpp"
#include "core/weight.hpp"
#include "problems/problem.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// A condition on one primitive's piece of the boundary, or on the part of it where `where` ≥ 0,
/// with its data as fields.
struct PieceCondition {
  int primitive = 0;
  std::string name;     ///< of the piece
  int component = 0;    ///< the unknown, by its number
  std::string unknown;  ///< its name where there are several, for messages
  Condition::Kind kind = Condition::Kind::value;
  Condition::Enforcement enforcement = Condition::Enforcement::automatic;
  std::optional<Field> where;
  bool clamped = false;  ///< a value of 0 whose normal derivative vanishes, too
  /// Value; flux; coefficient h and ambient; a, b, c: in the order of the contract. Of an oblique
  /// derivative the value, then the direction. Of
  /// interpolation the value, if there is one, and normal derivatives by order.
  std::vector<Field> data;
  int exponent = 0;  ///< as that of `Condition`
  /// Position in the problem's list; conditions of one entry share their data as written.
  int condition = 0;
};

/// The conditions of a problem, piece by piece and unknown by unknown, for the primitives that
/// bound the domain; an unknown that a condition leaves free has zero flux there. Where several
/// claim parts of a piece, their `where` exclude each other by priority. Parts chosen by geometry
/// turn out to be nothing or all of a piece by their measure in `rule`, which is split where they
/// end. Throws `ProblemFileErrors` for pieces without a condition and conditions without a piece.
std::vector<PieceCondition> piece_conditions(const Problem& problem, const RegionEvaluator& region,
                                             const std::vector<int>& bounding_primitives,
                                             const DomainRule& rule);

/// How the value conditions are met: u = g + ω Ψ on the pieces enforced by structure, boundary
/// integrals (Nitsche) on the others.
struct DirichletPlan {
  Field data = 0.0;        ///< g
  Structure given = 0.0;   ///< g as it is written
  Weight weight{1.0, ""};  ///< ω; 1 where nothing is enforced by structure
  /// How far from all pieces with values by structure: zero on them, at most 1, without dimension.
  Field distance = 1.0;
  /// How far from the nearest of them, to first order: an R₀-conjunction, which a product is not.
  Field nearest = 1.0;
  /// The structure of the user's own, as text: then g is its inhomogeneous part, and ω is not used.
  std::string own_structure = {};
  /// The sets of equal data that g interpolates, and the functions that vanish on them.
  struct DataSet {
    std::string pieces;
    std::string distance;
  };
  std::vector<DataSet> data_sets;
  std::vector<PieceCondition> by_structure;
  std::vector<PieceCondition> weakly;
  /// One line for each condition that is enforced weakly without having asked for it.
  std::vector<std::string> remarks;
  /// ω is made of another expression of the domain, which has no zeros inside.
  bool uses_regular_form = false;
  /// g is all of u, which interpolates so many sets of data; there is no ω.
  int interpolated_sets = 0;
};

/// Divides the value conditions of one unknown, whose conditions are given. By structure: whole
/// pieces whose conjunct of the domain's expression is prescribed on all its pieces; weakly: parts
/// of pieces (the structure loses order at their ends: u/ω is singular there), pieces of a conjunct
/// prescribed in part, data that are undefined somewhere in the domain, and what the file asks for.
/// `enforce: structure` forces the rest, by trimmed functions. Where the whole boundary is
/// prescribed by structure, ω is that of `regular_form` if there is one (core/regular_form.hpp).
DirichletPlan plan_dirichlet(const std::vector<PieceCondition>& conditions,
                             const RegionEvaluator& region, const Box& bounds,
                             const WeightOptions& options, const std::vector<bool>& data_is_regular,
                             const std::optional<BooleanExpression>& regular_form = {});

}  // namespace rfm
