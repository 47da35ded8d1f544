#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/expression.hpp"
#include "core/graded_lines.hpp"
#include "core/part_ends.hpp"
#include "core/region.hpp"
#include "core/separators.hpp"
#include "core/thin_set.hpp"
#include "core/weight.hpp"
#include "problems/document.hpp"
#include "quadrature/grading.hpp"

namespace rfm {

/// A formula whose names may have their meaning later: results exist only after the solve, the
/// normal only on a boundary. It was checked when the file was read, with stand-ins for those
/// names.
class DeferredExpression {
 public:
  /// Throws `ProblemFileErrors` if the text is not a formula.
  explicit DeferredExpression(DocumentNode node);

  /// As written: also the name of a probe's value.
  const std::string& text() const { return node_.text; }
  const Place& place() const { return node_.place; }
  bool uses(std::string_view name) const { return expression_.uses(name); }
  const Expression& expression() const { return expression_; }
  /// The value, given the meaning of all names. Throw `ProblemFileErrors` at the place in the file.
  ExpressionValue value(const ExpressionScope& scope) const;
  Field field(const ExpressionScope& scope) const;

 private:
  DocumentNode node_;
  Expression expression_;
};

/// A number or function (one entry), or a matrix row by row (dimension² entries).
struct PhysicalCoefficient {
  std::vector<Field> entries = {Field(0.0)};
  bool is_matrix = false;
  Place place;
};

/// A part of the domain with coefficients of its own.
struct Material {
  /// Nothing for `rest`: what no other material covers.
  std::optional<Region> region;
  std::string text;
  std::map<std::string, PhysicalCoefficient> coefficients;
  Place place;
};

enum class PhysicsType { poisson, heat, torsion, membrane, interpolation, custom };

/// What is asked of the equation.
struct Study {
  enum class Type { steady, eigen } type = Type::steady;
  int count = 6;     ///< of eigenvalues
  double shift = 0;  ///< where they begin
};

/// A part of the boundary, as names: some pieces (primitives), or parts of pieces.
struct BoundaryTarget {
  enum class Kind { pieces, all, rest };
  /// As written: `hole`, `plate.left`, a region, `all`, `rest`.
  std::string name;
  Kind kind = Kind::pieces;
  /// Names of primitives of the domain; empty for `rest`. Not all of them need bound the domain.
  std::vector<std::string> pieces;
  /// Only the part where this is ≥ 0.
  std::optional<Field> where;
  /// Of a region that geometry chooses (by a normal, a shape or a surface): the part of each piece
  /// of which it holds not all. Which of its pieces hold any of it, their measures tell.
  std::map<std::string, Field> parts;
  /// Where the parts end.
  std::vector<PartEnds> ends;
  bool chosen_by_geometry = false;
  Place place;

  /// Where ≥ 0 on this piece, if it is not all of it.
  std::optional<Field> where_on(const std::string& piece) const;
};

/// An equation of one's own: formulas of the unknowns as symbols (problems/solution_symbols.hpp).
struct CustomPhysics {
  enum class Kind { energy, weak, residuals };
  Kind kind = Kind::energy;
  /// One energy or weak form, or the residuals.
  std::vector<Field> formulas;
  /// An integral over a part of the boundary; it may use the normal.
  struct BoundaryForm {
    std::vector<BoundaryTarget> targets;
    Kind kind = Kind::energy;
    std::optional<DeferredExpression> formula;
    Place place;
  };
  std::vector<BoundaryForm> boundary;
  Place place;
};

struct Physics {
  PhysicsType type = PhysicsType::poisson;
  /// What is solved for: the components of the solution, by name.
  std::vector<std::string> unknowns = {"u"};
  /// By key: diffusivity, reaction, source; conductivity, density, heat_capacity, source. They may
  /// contain the solution, as a symbol (problems/solution_symbols.hpp). Those
  /// that neither the file nor a default gives (conductivity beside materials) are absent.
  std::map<std::string, PhysicalCoefficient> coefficients;
  std::vector<Material> materials;
  /// a in −∇·(K∇u) + a·∇u + …; empty for none. Of `poisson`.
  std::vector<Field> advection;
  std::optional<CustomPhysics> custom;
};

struct Condition {
  /// `slope`: of interpolation, a normal derivative without a value.
  /// `oblique`: a derivative along any direction.
  enum class Kind { value, flux, convection, robin, slope, oblique };
  enum class Enforcement { automatic, structure, weak };
  std::vector<BoundaryTarget> targets;
  Kind kind = Kind::value;
  /// By key: `flux`; `coefficient`, `ambient`; `a`, `b`, `c`; of an oblique derivative
  /// `direction.x`, … and `value`; of `value`, by unknown: unknowns that
  /// are left out are free; of interpolation also `normal_derivative`, `second_normal_derivative`.
  /// They may use `n.x`, …: see `normal_scope`.
  std::map<std::string, DeferredExpression> data;
  Enforcement enforcement = Enforcement::automatic;
  /// Values and normal derivatives of all unknowns vanish: kind `value`, without data.
  bool clamped = false;
  int exponent = 0;  ///< of interpolation; 0: one more than the order that is prescribed
  int priority = 0;
  Place place;
};

/// Values of a parameter of the file, as written, that a nonlinear problem is solved for on the way
/// to its own.
struct Continuation {
  std::string parameter;
  std::vector<std::string> values;
};

/// Knots along an axis, that is grid lines, other than those of equal cells.
struct AxisKnots {
  std::vector<double> lines;  ///< as listed; none where cells are graded
  LineGrading grading;
  std::optional<double> within;  ///< of the grading; nothing: a quarter of the side
  Place place;
};

struct Discretization {
  /// Splines on the grid, or functions that live on the whole of it: then the grid is one of
  /// quadrature only.
  enum class Basis { bspline, legendre, chebyshev, power, trigonometric } basis = Basis::bspline;
  int degree = 3;
  /// Degrees of unknowns that differ from it, by name.
  std::map<std::string, int> degrees;
  /// Of polynomials: whether `degree` bounds the sum of the exponents, or each of them.
  bool total_degree = true;
  /// One number (along the longest side) or one per dimension; empty where `cell_size` is given.
  std::vector<int> cells;
  std::optional<double> cell_size;
  std::array<std::optional<AxisKnots>, 3> knots;
  /// Splines cut thinly are attached to inner ones (basis/web_extension.hpp).
  bool extension = false;
  std::optional<Box> grid;
  /// Gauss points in each direction of a cell, where the file chooses them.
  std::optional<int> quadrature_order;
  /// Points and segments towards which the integration is refined.
  std::vector<Grading> gradings;
  /// Ritz's method is Galerkin's where the equation follows from no energy.
  enum class Method { ritz, galerkin, least_squares, collocation } method = Method::ritz;
  /// Where residuals are collocated.
  enum class Points { gauss, greville } points = Points::gauss;
  /// Of least squares.
  enum class Factorization { automatic, normal_equations, qr };
  Factorization factorization = Factorization::automatic;
  enum class LinearSolver { automatic, direct } linear_solver = LinearSolver::automatic;
  double tolerance = 1e-12;
  /// Steps in which Newton's method brings the residual down (solvers/newton.hpp).
  int load_steps = 1;
  std::optional<Continuation> continuation;
  std::optional<int> threads;
};

struct Probe {
  enum class Kind { point, line, integral, average, max, min };
  std::string name;
  Kind kind = Kind::point;
  /// The point, or the ends of the line.
  std::vector<Point> points;
  int point_count = 1;
  /// What is probed, by the name under which it is kept: the text as written, or a name.
  std::vector<std::pair<std::string, DeferredExpression>> values;
  /// Of integrals and extremes: the domain, a part of it, a part of its boundary, or the part
  /// of a set that lies in the domain.
  enum class Over { domain, shape, boundary, set } over = Over::domain;
  std::optional<Region> region;
  std::optional<BoundaryTarget> boundary;
  std::optional<ThinSet> set;
  Place place;
};

/// What a file asks under `relations`, and the answer (core/relations.hpp): certified, with a
/// witness where there is one.
struct GeometricRelation {
  enum class Kind { intersect, inside, distance, point };
  std::string name;
  Kind kind = Kind::intersect;
  /// As written, for messages.
  std::vector<std::string> texts;
  std::vector<Region> regions;  ///< two, or one in which a point lies
  Point point{};
  /// Of distances: how far their bounds may be apart; nothing: 10⁻⁶ of the larger shape.
  std::optional<double> tolerance;
  Place place;
};

struct Expectation {
  /// A path into the summary, as `probes.centre.u`.
  std::string quantity;
  double value = 0;
  std::optional<double> tolerance;
  std::optional<double> relative_tolerance;
  Place place;
};

struct OrderBounds {
  std::string norm;  // L2, H1, max, eigenvalues
  double least = 0;
  std::optional<double> most;
};

struct ConvergenceCheck {
  std::vector<int> cells;
  std::vector<OrderBounds> orders;
};

struct Verification {
  /// The exact solution by unknown.
  std::map<std::string, Field> exact;
  /// Exact eigenvalues, ascending from the shift of the study.
  std::vector<double> eigenvalues;
  std::vector<Expectation> expectations;
  std::optional<ConvergenceCheck> convergence;
};

struct Picture {
  /// A formula of results: a scalar is drawn in colours, a vector with arrows.
  std::string field = "u";
  /// About how many contour lines; they lie at round numbers.
  int contours = 10;
  int width = 1000;  ///< in pixels
  /// What the colours span; nothing: from the smallest to the largest value.
  std::optional<std::pair<double, double>> range;
  enum class Colours { uniform, diverging } colours = Colours::uniform;
  /// In space: the direction towards the viewer (z is up).
  Point view{1, -1.7, 1.1};
  /// In space: whether the body is shown cut open beside the whole one.
  bool with_cut = true;
  /// The plane of the cut: what `cut_normal` points to is taken away. Nothing: through the middle
  /// of the domain, across the axis that comes nearest to the view.
  std::optional<Point> cut_point, cut_normal;
};

struct Outputs {
  std::vector<std::string> fields;
  int resolution = 128;
  std::optional<Picture> picture;
  /// Whether the points of the integration are written too.
  bool rule = false;
};

/// A problem file, read and checked: names are resolved, numbers are numbers, defaults are filled
/// in.
struct Problem {
  std::string file;
  std::string title;
  int dimension = 2;
  std::map<std::string, double> parameters;
  /// What formulas may name: coordinates, parameters, fields, functions, derivatives, omega(name).
  /// Copies of it get results and normals (result_scope.hpp).
  ExpressionScope scope;
  /// Names of `fields:`, which may be outputs.
  std::vector<std::string> fields;

  std::map<std::string, Region> shapes;
  std::map<std::string, ThinSet> sets;
  /// Shapes given by the sets that their boundaries are made of.
  std::map<std::string, DescribedSolid> described;
  std::optional<Region> domain;  ///< never empty in a problem that was read
  WeightOptions combine;
  std::optional<Box> bounds;
  std::map<std::string, BoundaryTarget> regions;
  std::vector<GeometricRelation> relations;
  std::vector<Condition> conditions;
  Place conditions_place;

  Physics physics;
  Study study;
  Discretization discretization;
  std::vector<Probe> probes;
  Verification verification;
  Outputs outputs;

  /// The file as read, with defaults and overrides, for `input.resolved.yaml`.
  DocumentNode document;
};

}  // namespace rfm
