#include "problems/run_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/nearest_name.hpp"
#include "problems/knots_reader.hpp"
#include "problems/picture_view_reader.hpp"
#include "problems/result_scope.hpp"

namespace rfm {
namespace {

std::vector<int> read_cells(const DocumentNode& node, ValueReader& values) {
  if (node.is_scalar()) {
    const std::optional<int> cells = values.integer(node);
    return cells ? std::vector<int>{*cells} : std::vector<int>{};
  }
  if (static_cast<int>(node.items.size()) != values.dimension) {
    values.mistakes.add("expected one number of cells, or " + std::to_string(values.dimension) +
                            ", but found " + std::to_string(node.items.size()),
                        node.place);
    return {};
  }
  return values.integers(node).value_or(std::vector<int>{});
}

void read_curve(const DocumentNode& node, ValueReader& values, Grading& grading) {
  const int needed = values.dimension - 1;
  if (static_cast<int>(node.items.size()) != needed)
    return values.mistakes.add(
        values.dimension == 1
            ? "a line has no curves; expected a point"
            : fmt::format(
                  "expected {} on a curve {}, but found {}",
                  needed == 1 ? "the formula that is zero" : "the two formulas that are zero",
                  needed == 1 ? "of the plane" : "of space", node.items.size()),
        node.place);
  for (const DocumentNode& item : node.items)
    if (const std::optional<Field> function = values.field(item))
      grading.curve.push_back(std::make_shared<LevelFunction>(*function, values.dimension));
}

Grading read_grading(const DocumentNode& node, ValueReader& values) {
  Grading grading;
  const auto read_point = [&](const DocumentNode& map, const char* key, Point& point) {
    if (const DocumentNode* value = values.find(map, key))
      point = values.point(*value).value_or(point);
  };
  read_point(node, "point", grading.from);
  grading.to = grading.from;
  if (const DocumentNode* segment = values.find(node, "segment")) {
    read_point(*segment, "from", grading.from);
    read_point(*segment, "to", grading.to);
  }
  if (const DocumentNode* curve = values.find(node, "curve")) read_curve(*curve, values, grading);
  if (const DocumentNode* levels = values.find(node, "levels"))
    grading.levels = values.integer(*levels).value_or(grading.levels);
  if (const DocumentNode* ratio = values.find(node, "ratio"))
    grading.ratio = values.number(*ratio).value_or(grading.ratio);
  if (const DocumentNode* reach = values.find(node, "reach"))
    grading.reach = values.number(*reach).value_or(grading.reach);
  return grading;
}

void check_formula_of_results(const DocumentNode& node, ValueReader& values) {
  ExpressionScope scope = values.scope;
  define_results(scope, values.results);
  refuse_normal(scope, values.dimension, "is known on a boundary only");
  values.deferred(node, scope);
}

std::optional<Picture> read_picture(const DocumentNode& node, ValueReader& values) {
  if (node.is_scalar() && node.text != "true") return std::nullopt;
  Picture picture;
  picture.field = values.results.unknowns[0].name;
  if (const DocumentNode* field = values.find(node, "field")) {
    check_formula_of_results(*field, values);
    picture.field = field->text;
  }
  if (const DocumentNode* contours = values.find(node, "contours"))
    picture.contours = values.integer(*contours).value_or(picture.contours);
  if (const DocumentNode* width = values.find(node, "width"))
    picture.width = values.integer(*width).value_or(picture.width);
  if (const DocumentNode* colours = values.find(node, "colours"))
    if (colours->text == "diverging") picture.colours = Picture::Colours::diverging;
  if (const DocumentNode* range = values.find(node, "range")) {
    const auto bounds = values.numbers(*range);
    if (bounds && (bounds->size() != 2 || !((*bounds)[0] < (*bounds)[1])))
      values.mistakes.add("expected two numbers [low, high] with low < high", range->place);
    else if (bounds)
      picture.range = {(*bounds)[0], (*bounds)[1]};
  }
  read_view(node, values, picture);
  return picture;
}

}  // namespace

Study read_study(const DocumentNode& root, ValueReader& values) {
  Study study;
  const DocumentNode* map = values.find(root, "study");
  const DocumentNode* type = map ? values.find(*map, "type") : nullptr;
  if (!type || type->text != "eigen") return study;
  study.type = Study::Type::eigen;
  const DocumentNode* physics = values.find(root, "physics");
  const DocumentNode* kind = physics ? values.find(*physics, "type") : nullptr;
  if (kind && kind->text == "torsion")
    values.mistakes.add(
        "torsion has no mass, so that it has no modes; expected: poisson, heat, membrane",
        kind->place);
  if (kind && kind->text == "custom" && !physics->find("mass"))
    values.mistakes.add("modes of custom physics need a `mass`", kind->place);
  if (const DocumentNode* count = values.find(*map, "count"))
    study.count = values.integer(*count).value_or(study.count);
  if (const DocumentNode* shift = values.find(*map, "shift"))
    study.shift = values.number(*shift).value_or(study.shift);
  return study;
}

namespace {

void read_polynomials(const DocumentNode& basis, ValueReader& values, Discretization& result) {
  using Basis = Discretization::Basis;
  for (const auto& [key, kind] :
       {std::pair{"legendre", Basis::legendre}, std::pair{"chebyshev", Basis::chebyshev},
        std::pair{"power", Basis::power}, std::pair{"trigonometric", Basis::trigonometric}})
    if (const DocumentNode* degree = values.find(basis, key)) {
      result.basis = kind;
      result.degree = values.integer(*degree).value_or(result.degree);
    }
  if (const DocumentNode* degree = values.find(basis, "degree"))
    result.total_degree = degree->text != "maximal";
}

Continuation read_continuation(const DocumentNode& root, const DocumentNode& map,
                               ValueReader& values) {
  Continuation result;
  if (const DocumentNode* numbers = values.find(map, "values")) {
    values.numbers(*numbers);
    for (const DocumentNode& number : numbers->items) result.values.push_back(number.text);
  }
  const DocumentNode* name = values.find(map, "parameter");
  if (!name) return result;
  result.parameter = name->text;
  std::vector<std::string> known;
  if (const DocumentNode* parameters = root.find("parameters"))
    for (const DocumentNode::Entry& entry : parameters->entries) known.push_back(entry.key);
  if (std::ranges::find(known, name->text) == known.end())
    values.mistakes.add(
        fmt::format("unknown parameter '{}'{}", name->text, did_you_mean(name->text, known)),
        name->place);
  return result;
}

// What only some methods have.
void read_factorization(const DocumentNode& solver, ValueReader& values, Discretization& result) {
  using Method = Discretization::Method;
  const DocumentNode* points = values.find(solver, "points");
  if (points && points->text == "greville") {
    result.points = Discretization::Points::greville;
    if (result.method != Method::collocation)
      values.mistakes.add("points are chosen where `method` is collocation", points->place);
  }
  const DocumentNode* factorization = values.find(solver, "factorization");
  if (!factorization || factorization->text == "auto") return;
  result.factorization = factorization->text == "qr"
                             ? Discretization::Factorization::qr
                             : Discretization::Factorization::normal_equations;
  if (result.method != Method::least_squares)
    values.mistakes.add("a factorization is chosen where `method` is least_squares",
                        factorization->place);
}

// Extended splines and functions of the whole domain are those of systems; rows at points have
// splines of their own.
void check_basis(const DocumentNode& map, ValueReader& values, const Discretization& result) {
  const bool at_points = result.method == Discretization::Method::collocation ||
                         result.factorization == Discretization::Factorization::qr;
  if (result.basis != Discretization::Basis::bspline && at_points)
    values.mistakes.add(
        "functions of the whole domain are found by Ritz's and Galerkin's method, and by least "
        "squares with normal equations",
        map.find("basis")->place);
  if (result.extension && at_points)
    values.mistakes.add(
        "splines are extended by Ritz's and Galerkin's method, and by least squares with normal "
        "equations",
        map.find("basis")->find("extension")->place);
}

}  // namespace

Discretization read_discretization(const DocumentNode& root, ValueReader& values,
                                   const std::vector<std::string>& unknowns) {
  Discretization result;
  const DocumentNode* map = values.find(root, "discretization");
  if (!map) return result;
  if (const DocumentNode* basis = values.find(*map, "basis")) {
    if (const DocumentNode* degree = values.find(*basis, "bspline"))
      result.degree = values.integer(*degree).value_or(result.degree);
    read_polynomials(*basis, values, result);
    if (const DocumentNode* cells = values.find(*basis, "cells"))
      result.cells = read_cells(*cells, values);
    if (const DocumentNode* size = values.find(*basis, "size"))
      result.cell_size = values.number(*size);
    if (const DocumentNode* extension = values.find(*basis, "extension"))
      result.extension = extension->text == "true";
    if (const DocumentNode* degrees = values.find(*basis, "degrees"))
      for (const DocumentNode::Entry& entry : degrees->entries) {
        if (std::ranges::find(unknowns, entry.key) == unknowns.end())
          values.mistakes.add(
              fmt::format("unknown result '{}' in degrees{}; expected: {}", entry.key,
                          did_you_mean(entry.key, unknowns), fmt::join(unknowns, ", ")),
              entry.key_place);
        else if (const auto degree = values.integer(entry.value))
          result.degrees.emplace(entry.key, *degree);
      }
  }
  if (const DocumentNode* grid = values.find(*map, "grid")) result.grid = values.box(*grid);
  if (const DocumentNode* basis = values.find(*map, "basis")) read_knots(*basis, values, result);
  if (const DocumentNode* method = values.find(*map, "method")) {
    if (method->text == "galerkin") result.method = Discretization::Method::galerkin;
    if (method->text == "least_squares") result.method = Discretization::Method::least_squares;
    if (method->text == "collocation") result.method = Discretization::Method::collocation;
  }
  if (const DocumentNode* quadrature = values.find(*map, "quadrature")) {
    if (const DocumentNode* order = values.find(*quadrature, "order"))
      result.quadrature_order = values.integer(*order);
    if (const DocumentNode* gradings = values.find(*quadrature, "grade"))
      for (const DocumentNode& item : gradings->items)
        if (values.fits(item)) result.gradings.push_back(read_grading(item, values));
  }
  if (const DocumentNode* solver = values.find(*map, "solver")) {
    if (const DocumentNode* linear = values.find(*solver, "linear"))
      result.linear_solver = linear->text == "direct" ? Discretization::LinearSolver::direct
                                                      : Discretization::LinearSolver::automatic;
    if (const DocumentNode* tolerance = values.find(*solver, "tolerance"))
      result.tolerance = values.number(*tolerance).value_or(result.tolerance);
    read_factorization(*solver, values, result);
    if (const DocumentNode* steps = values.find(*solver, "load_steps"))
      result.load_steps = values.integer(*steps).value_or(result.load_steps);
    if (const DocumentNode* path = values.find(*solver, "continuation"))
      result.continuation = read_continuation(root, *path, values);
    if (const DocumentNode* threads = values.find(*solver, "threads"))
      result.threads = values.integer(*threads);
  }
  check_basis(*map, values, result);
  return result;
}

void read_outputs(const DocumentNode& root, ValueReader& values, Problem& problem) {
  // In space 128 points along each side would be a file of 100 MB.
  problem.outputs.resolution = problem.dimension == 3 ? 48 : 128;
  const DocumentNode* map = values.find(root, "outputs");
  if (!map) return;
  std::vector<std::string> known = output_names(values.results);
  known.insert(known.end(), problem.fields.begin(), problem.fields.end());
  const auto check_name = [&](const DocumentNode& node) {
    if (std::ranges::find(known, node.text) == known.end())
      values.mistakes.add(
          "unknown result or field '" + node.text + "'" + did_you_mean(node.text, known),
          node.place);
  };
  if (const DocumentNode* fields = values.find(*map, "fields"))
    for (const DocumentNode& item : fields->items) {
      if (!values.fits(item)) continue;
      check_name(item);
      problem.outputs.fields.push_back(item.text);
    }
  if (const DocumentNode* vtu = values.find(*map, "vtu"))
    if (const DocumentNode* resolution = values.find(*vtu, "resolution"))
      problem.outputs.resolution = values.integer(*resolution).value_or(problem.outputs.resolution);
  if (const DocumentNode* rule = values.find(*map, "rule"))
    problem.outputs.rule = rule->text == "true";
  if (const DocumentNode* picture = values.find(*map, "picture"))
    problem.outputs.picture = read_picture(*picture, values);
}

}  // namespace rfm
