#include "problems/check.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <numbers>
#include <span>

#include "core/tape.hpp"
#include "problems/described_solids.hpp"
#include "problems/distance_quality.hpp"
#include "problems/geometric_relations.hpp"
#include "problems/pictures/check_picture.hpp"
#include "problems/problem_forms.hpp"
#include "problems/reader.hpp"
#include "problems/result_folder.hpp"
#include "problems/run_log.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/worst_cells.hpp"
#include "quadrature/edges.hpp"
#include "quadrature/vertices.hpp"

namespace rfm {
namespace {

const char* kind_name(Condition::Kind kind) {
  switch (kind) {
    case Condition::Kind::value:
      return "value";
    case Condition::Kind::flux:
      return "flux";
    case Condition::Kind::convection:
      return "convection";
    case Condition::Kind::slope:
      return "normal derivative";
    case Condition::Kind::oblique:
      return "oblique derivative";
    default:
      return "robin";
  }
}

// Where no corner could be told: smooth joints of pieces, as a rule.
void log_unresolved(const std::vector<Point>& points, int dimension, RunLog& log) {
  if (points.empty()) return;
  constexpr std::size_t most_shown = 4;
  std::vector<std::string> places;
  for (const Point& point : std::span(points).first(std::min(most_shown, points.size()))) {
    std::vector<std::string> coordinates;
    for (int axis = 0; axis < dimension; ++axis)
      coordinates.push_back(fmt::format("{:.6g}", point[axis]));
    places.push_back(fmt::format("({})", fmt::join(coordinates, ", ")));
  }
  log.line("note: surfaces touch or are singular near {}{}", fmt::join(places, ", "),
           points.size() > most_shown
               ? fmt::format(" and in {} more places", points.size() - most_shown)
               : "");
}

// Corners of the plane; vertices and edges of space.
void log_corners(const ScalarProblem& problem, RunLog& log) {
  const RegionEvaluator& region = problem.region();
  if (region.dimension() == 1) return;
  const VertexSearch search = find_vertices(region, problem.bounds());
  if (region.dimension() == 2) {
    log.line("{} corners", search.vertices.size());
    constexpr std::size_t most_shown = 20;
    for (const Vertex& corner :
         std::span(search.vertices).first(std::min(most_shown, search.vertices.size())))
      log.line("  ({:.6g}, {:.6g}): {:.6g} degrees", corner.point[0], corner.point[1],
               180 / std::numbers::pi * corner.angle);
    if (search.vertices.size() > most_shown)
      log.line("  and {} more", search.vertices.size() - most_shown);
  } else {
    const EdgeRule edges = make_edge_rule(region, problem.bounds());
    log.line("{} vertices, edges of length {:.12g}", search.vertices.size(), edges.points.length());
    if (edges.report.order_difference > 1e-9 * edges.points.length())
      log.line("note: of the lengths of edges, orders differ by {:.1e}",
               edges.report.order_difference);
    if (edges.report.uncertified_boxes > 0)
      log.line("note: edges of length {:.3g} could not be resolved",
               edges.report.uncertified_length);
    if (edges.report.contact_boxes > 0) log.line("note: surfaces touch without forming an edge");
  }
  log_unresolved(search.unresolved, region.dimension(), log);
}

void log_accuracy(const DomainRule& rule, RunLog& log) {
  const QuadratureReport& report = rule.report();
  log.line(
      "quadrature: orders differ by {:.1e}, on the boundary by {:.1e}; divergence theorem {:.1e}",
      report.order_difference.volume, report.order_difference.boundary, report.divergence_defect);
  if (report.uncertified.boxes > 0)
    log.line(
        "note: quadrature is a best effort in {} boxes of total measure {:.1e}, with at most "
        "{:.1e} "
        "of the boundary",
        report.uncertified.boxes, report.uncertified.measure, report.uncertified.boundary);
  constexpr int most_cells = 3;
  for (const WorstCell& cell : worst_cells(rule, most_cells))
    log.line("  {}", as_text(cell, rule.dimension()));
}

// Of the piece of a condition, or of the part of it that is its own: rules are cut where parts end.
double measure_of(const PieceCondition& condition, const DomainRule& rule) {
  if (!condition.where) return rule.boundary_measure(condition.primitive);
  const SurfaceRule& boundary = rule.boundary();
  const Tape where({*condition.where}, {0}, rule.dimension());
  double measure = 0;
  for (int i = 0; i < boundary.points.size(); ++i)
    if (boundary.points.numbers[i] == condition.primitive &&
        where.value(boundary.points.point(i)) >= 0)
      measure += boundary.points.weights[i];
  return measure;
}

std::string quality_text(const Field& omega, const ScalarProblem& problem, const DomainRule& rule,
                         const std::vector<int>& pieces) {
  std::string text;
  for (const auto& [name, deviation] : distance_quality(omega, problem, rule, pieces))
    text += fmt::format("{}{} {:.1e}", text.empty() ? "" : ", ", name, deviation);
  return text;
}

void write_picture(const std::string& file, const std::string& output, const ScalarProblem& problem,
                   const DomainRule& rule, RunLog& log) {
  const int width = problem.problem().outputs.picture.value_or(Picture{}).width;
  const Image image = draw_check(problem, rule, width);
  ResultFolder folder(output);
  const std::string name = std::filesystem::path(file).stem().string() + ".check.png";
  folder.write(name, [&](const std::string& path) { write_png(image, path); });
  folder.commit();
  log.line("picture: {}/{}", output, name);
}

}  // namespace

int check_problem(const std::string& file, const CheckOptions& options) {
  if (options.picture) require_writable(options.output);
  const Problem problem = read_problem(file, options.overrides);
  const std::vector<RelationAnswer> relations = answered(problem.relations, problem.bounds);
  const ScalarProblem scalar(problem);
  if (problem.physics.type != PhysicsType::interpolation && uses_forms(scalar))
    problem_forms(scalar, scalar.grid());
  const Grid grid = scalar.grid();
  const DomainRule rule = scalar.rule(grid);
  RunLog log(false);
  const Box& box = scalar.bounds();
  log.line("{}: correct", file);
  for (int axis = 0; axis < box.dimension; ++axis)
    log.line("{}: {:.12g} to {:.12g}", "xyz"[axis], box.low[axis], box.high[axis]);
  if (const std::string note = bounds_note(scalar); !note.empty()) log.line("note: {}", note);
  log.line("measure of the domain {:.12g}, of its boundary {:.12g}", rule.measure(),
           rule.boundary_measure());
  log_accuracy(rule, log);
  for (const auto& [shape, solid] : problem.described)
    for (const std::string& line : description_lines(shape, solid)) log.line("{}", line);
  log_corners(scalar, log);
  for (const PieceCondition& condition : scalar.conditions())
    log.line("  {}: {}{}{}, measure {:.12g}", condition.name,
             condition.unknown.empty() ? "" : condition.unknown + " ", kind_name(condition.kind),
             condition.where ? " on a part" : "", measure_of(condition, rule));
  log.line("distance quality, largest | |grad omega(domain)| - 1 |: {}",
           quality_text(domain_function(scalar), scalar, rule, scalar.bounding_primitives()));
  const std::vector<std::optional<std::string>> lines = scalar.structure_lines(grid);
  for (std::size_t c = 0; c < scalar.dirichlet().size(); ++c) {
    const DirichletPlan& plan = scalar.dirichlet()[c];
    if (!plan.own_structure.empty()) {
      log.line("structure: {} = {}", problem.physics.unknowns[c], plan.own_structure);
    } else if (plan.interpolated_sets > 0) {
      log.line("{} interpolates the data of {} sets", problem.physics.unknowns[c],
               plan.interpolated_sets);
    } else if (!plan.by_structure.empty()) {
      log.line("structure: {} = g + omega psi, omega = {}", problem.physics.unknowns[c],
               plan.weight.formula);
      for (const WeightPart& part : plan.weight.parts)
        log.line("  {}: {}; smooth: {}", part.formula, part.rule, part.smoothness);
      std::vector<int> pieces;
      for (const PieceCondition& piece : plan.by_structure)
        if (!piece.where) pieces.push_back(piece.primitive);
      log.line("  largest | |grad omega| - 1 |: {}",
               quality_text(plan.weight.function, scalar, rule, pieces));
    } else {
      log.line("structure: {} = psi", problem.physics.unknowns[c]);
    }
    if (plan.own_structure.empty())
      log.line("  {}", lines[c] ? "discretization.structure: " + *lines[c]
                                : "it cannot be written as one line");
    for (const std::string& remark : plan.remarks) log.line("note: {}", remark);
  }
  for (const Irregularity& irregularity : scalar.irregularities())
    log.line("note: {}", describe(irregularity, scalar.region(), scalar.has_irregular_weight()));
  for (const RelationAnswer& answer : relations)
    log.line("{}", relation_text(answer, problem.dimension));
  log.line(
      "{} cells inside, {} cut; {} unknowns", rule.report().inside_cells, rule.report().cut_cells,
      problem.physics.type == PhysicsType::interpolation ? 0 : scalar.equations(rule, grid).size());
  if (options.picture) write_picture(file, options.output, scalar, rule, log);
  return 0;
}

}  // namespace rfm
