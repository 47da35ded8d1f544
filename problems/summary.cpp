#include "problems/summary.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <numbers>

#include "problems/distance_quality.hpp"
#include "problems/worst_cells.hpp"
#include "quadrature/edges.hpp"
#include "quadrature/vertices.hpp"

namespace rfm {
namespace {

using nlohmann::ordered_json;

ordered_json as_json(const ProbeValue& value) {
  if (value.is_vector) return value.components;
  return value.components[0];
}

ordered_json as_json(const Point& point, int dimension) {
  return std::vector<double>(point.begin(), point.begin() + dimension);
}

ordered_json as_json(const SolutionErrors& errors) {
  return {{"L2", errors.l2},
          {"L2_relative", errors.l2_relative},
          {"H1", errors.h1},
          {"H1_relative", errors.h1_relative},
          {"max", errors.maximum}};
}

// Peak resident memory of the process.
long peak_memory_mb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

void add_probes(ordered_json& summary, const std::vector<ProbeResult>& probes, int dimension) {
  for (const ProbeResult& result : probes) {
    ordered_json& entry = summary["probes"];
    switch (result.probe->kind) {
      case Probe::Kind::point:
        for (const ProbeValue& value : result.values)
          entry[result.probe->name][value.name] = as_json(value);
        break;
      case Probe::Kind::line:
        break;  // probes.csv
      case Probe::Kind::max:
      case Probe::Kind::min:
        entry[result.probe->name] = as_json(result.values[0]);
        entry[result.probe->name + "_at"] = as_json(result.at, dimension);
        break;
      default:
        entry[result.probe->name] = as_json(result.values[0]);
    }
  }
}

// How many corners the plane has; how many vertices space, and the length of its edges, whose
// accuracy is returned.
ordered_json add_corners(ordered_json& measures, const ScalarProblem& problem) {
  const RegionEvaluator& region = problem.region();
  if (region.dimension() == 1) return {};
  const std::size_t count = find_vertices(region, problem.bounds()).vertices.size();
  measures[region.dimension() == 2 ? "corners" : "vertices"] = count;
  if (region.dimension() < 3) return {};
  const EdgeRule edges = make_edge_rule(region, problem.bounds());
  measures["edges"] = edges.points.length();
  return {{"order_difference", edges.report.order_difference},
          {"uncertified_length", edges.report.uncertified_length},
          {"contact_boxes", edges.report.contact_boxes}};
}

void add_eigenvalues(ordered_json& summary, const EigenResult& eigen, const RunReport& report) {
  summary["eigenvalues"] = eigen.values;
  summary["frequencies"] = eigen.frequencies();
  for (const double frequency : eigen.frequencies())
    summary["angular_frequencies"].push_back(2 * std::numbers::pi * frequency);
  summary["modes"] = {
      {"residuals", eigen.residuals}, {"present", eigen.present}, {"below", eigen.upper}};
  if (report.eigenvalue_error)
    summary["errors"]["eigenvalues"]["relative"] = *report.eigenvalue_error;
}

std::string method_name(LinearSolution::Method method) {
  switch (method) {
    case LinearSolution::Method::cholesky:
      return "cholesky";
    case LinearSolution::Method::ldlt:
      return "ldlt";
    case LinearSolution::Method::lu:
      return "lu";
    case LinearSolution::Method::qr:
      return "qr";
    case LinearSolution::Method::eigenvectors:
      return "eigenvectors";
    default:
      return "conjugate_gradient";
  }
}

const char* linearity_name(Linearity linearity) {
  if (linearity == Linearity::none) return "no";
  return linearity == Linearity::by_form ? "by form" : "by value";
}

// The structures as they may be written into the file, and what their weights are made of: one
// text, or one for each unknown.
void add_structures(ordered_json& summary, const ScalarProblem& problem, const Grid& grid) {
  const std::vector<std::optional<std::string>> lines = problem.structure_lines(grid);
  const auto add = [&](const char* key, std::size_t c, const std::string& text) {
    if (lines.size() == 1)
      summary[key] = text;
    else
      summary[key][problem.problem().physics.unknowns[c]] = text;
  };
  for (std::size_t c = 0; c < lines.size(); ++c) {
    if (lines[c]) add("structure", c, *lines[c]);
    const DirichletPlan& plan = problem.dirichlet()[c];
    if (plan.own_structure.empty()) add("weight", c, plan.weight.formula);
  }
}

}  // namespace

bool RunReport::all_ok() const {
  return std::ranges::all_of(orders, &OrderCheck::ok) &&
         std::ranges::all_of(expectations, &ExpectationResult::ok);
}

std::string version() { return RFM_VERSION; }

ordered_json make_summary(const ScalarProblem& problem, const ScalarSolution& solution,
                          const RunReport& report) {
  const Problem& file = problem.problem();
  const QuadratureReport& quadrature = solution.rule.report();
  ordered_json summary;
  summary["problem"] = file.file;
  if (!file.title.empty()) summary["title"] = file.title;
  summary["status"] = "ok";
  summary["version"] = version();
  summary["unknowns"] = solution.unknowns;
  summary["cells"] = {{"inside", quadrature.inside_cells},
                      {"cut", quadrature.cut_cells},
                      {"smallest_cut", quadrature.smallest_cut_fraction}};
  ordered_json& measures = summary["measures"];
  measures["domain"] = solution.rule.measure();
  measures["boundary_total"] = solution.rule.boundary_measure();
  for (int k : problem.bounding_primitives())
    measures["boundary"][problem.region().region().primitives()[k]->name] =
        solution.rule.boundary_measure(k);
  const ordered_json edges = add_corners(measures, problem);
  for (const auto& [name, deviation] : distance_quality(
           domain_function(problem), problem, solution.rule, problem.bounding_primitives()))
    summary["distance_quality"][name] = deviation;
  if (solution.energy) summary["energy"] = *solution.energy;
  if (!solution.eigen) summary["linear"] = linearity_name(solution.linearity);
  for (const NewtonIteration& iteration : solution.newton)
    summary["newton"]["steps"].push_back({{"residual", iteration.residual},
                                          {"step", iteration.step},
                                          {"damping", iteration.damping}});
  if (solution.newton_order) summary["newton"]["order"] = *solution.newton_order;
  summary["boundary_residual"] = solution.boundary_residual;
  if (report.errors)
    for (const auto& [name, errors] : report.errors->by_unknown)
      summary["errors"][name] = as_json(errors);
  if (solution.eigen) add_eigenvalues(summary, *solution.eigen, report);
  add_probes(summary, report.probes, file.dimension);
  if (!report.relations.empty())
    summary["relations"] = relations_json(report.relations, file.dimension);
  for (const ConvergenceRow& row : report.convergence) {
    ordered_json entry{{"cells", row.cells}, {"unknowns", row.unknowns}};
    if (row.errors) entry.update(as_json(*row.errors));
    if (row.change) entry["change_L2_relative"] = *row.change;
    if (row.eigenvalue_error) entry["eigenvalues_relative"] = *row.eigenvalue_error;
    summary["convergence"].push_back(std::move(entry));
  }
  for (const RunReport::OrderCheck& check : report.orders) {
    ordered_json entry{
        {"norm", check.norm}, {"order", check.order}, {"minimum", check.bounds.least}};
    if (check.bounds.most) entry["maximum"] = *check.bounds.most;
    entry["ok"] = check.ok;
    summary["orders"].push_back(std::move(entry));
  }
  summary["trust"] = {
      {"divergence_defect", quadrature.divergence_defect},
      {"order_difference",
       {{"domain", quadrature.order_difference.volume},
        {"boundary_total", quadrature.order_difference.boundary}}},
      {"uncertified_measure", quadrature.uncertified.measure},
      {"uncertified_boundary", quadrature.uncertified.boundary},
      {"linear_residual", solution.linear.relative_residual},
      {"linear_solver", solution.eigen ? "lanczos" : method_name(solution.linear.method)},
      {"smallest_eigenvalue", solution.linear.smallest_eigenvalue},
      {"dropped_splines", solution.linear.dropped}};
  if (solution.rule.interfaces().points.size() > 0)
    summary["trust"]["order_difference"]["interfaces"] = quadrature.order_difference.interfaces;
  if (!edges.empty()) summary["trust"]["edges"] = edges;
  if (solution.linear.dependent > 0)
    summary["trust"]["dependent_functions"] = solution.linear.dependent;
  if (solution.undetermined) summary["trust"]["undetermined"] = *solution.undetermined;
  constexpr int most_cells = 5;
  if (const auto cells = worst_cells(solution.rule, most_cells); !cells.empty())
    summary["trust"]["worst_cells"] = as_json(cells, file.dimension);
  for (const std::string& note : solution.notes) summary["notes"].push_back(note);
  for (const std::string& note : report.notes) summary["notes"].push_back(note);
  add_structures(summary, problem, solution.rule.grid());
  const RunReport::Seconds& seconds = report.seconds;
  summary["seconds"] = {{"read", seconds.read},
                        {"prepare", seconds.prepare},
                        {"quadrature", seconds.quadrature},
                        {"assembly", seconds.assembly},
                        {"solve", seconds.solve},
                        {"verify", seconds.verify},
                        {"output", seconds.output},
                        {"total", seconds.total}};
  summary["peak_memory_mb"] = peak_memory_mb();
  return summary;
}

void add_expectations(ordered_json& summary, const RunReport& report) {
  for (const ExpectationResult& result : report.expectations)
    summary["expect"].push_back({{"quantity", result.quantity},
                                 {"value", result.value},
                                 {"expected", result.expected},
                                 {"relative_error", result.relative_error},
                                 {"ok", result.ok}});
}

std::string probes_csv(const std::vector<ProbeResult>& probes) {
  std::string rows;
  bool has_lines = false;
  for (const ProbeResult& result : probes) {
    has_lines = has_lines || result.probe->kind == Probe::Kind::line;
    for (std::size_t i = 0; i < result.line_values.size(); ++i) {
      const Point& at = result.line_points[i];
      for (const ProbeValue& value : result.line_values[i])
        for (std::size_t c = 0; c < value.components.size(); ++c)
          rows += fmt::format("{},{},{},{},\"{}{}\",{}\n", result.probe->name, at[0], at[1], at[2],
                              value.name, value.is_vector ? fmt::format("[{}]", c) : "",
                              value.components[c]);
    }
  }
  return has_lines ? "probe,x,y,z,quantity,value\n" + rows : "";
}

}  // namespace rfm
