#include "problems/run.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>

#include "core/error.hpp"
#include "problems/output/vtp_file.hpp"
#include "problems/output/vtu_file.hpp"
#include "problems/pictures/write_pictures.hpp"
#include "problems/reader.hpp"
#include "problems/resolved_document.hpp"
#include "problems/result_folder.hpp"
#include "problems/result_meshes.hpp"
#include "problems/rule_points.hpp"
#include "problems/solution_log.hpp"
#include "problems/stopwatch.hpp"
#include "problems/summary.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// Names of files may be of any encoding; JSON is UTF-8.
std::string json_text(const nlohmann::ordered_json& summary) {
  return summary.dump(2, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

void log_errors(RunLog& log, const std::string& name, const SolutionErrors& errors) {
  log.line("error of {}: L2 {:.3e} (relative {:.3e}), H1 {:.3e} (relative {:.3e}), max {:.3e}",
           name, errors.l2, errors.l2_relative, errors.h1, errors.h1_relative, errors.maximum);
}

// Change of the solution in L2, relative to it.
double relative_change(const ScalarSolution& solution, const ScalarResults& previous) {
  double size = 0, change = 0;
  for (std::size_t c = 0; c < previous.unknowns.size(); ++c) {
    const Field& field = solution.results.unknowns[c].field;
    size = std::hypot(size, norms(field, solution.rule).l2);
    change = std::hypot(change, norms(field - previous.unknowns[c].field, solution.rule).l2);
  }
  return size > 0 ? change / size : change;
}

// Where exact eigenvalues are known.
std::optional<double> eigenvalue_error(const ScalarProblem& problem,
                                       const ScalarSolution& solution) {
  const std::vector<double>& exact = problem.problem().verification.eigenvalues;
  if (!solution.eigen || exact.empty()) return std::nullopt;
  return rfm::eigenvalue_error(solution.eigen->values, exact);
}

// The error of a row in a norm and its order from the row before, both "-" where there is none.
std::array<std::string, 2> error_texts(const std::vector<ConvergenceRow>& rows, std::size_t i,
                                       const char* norm) {
  const std::optional<double> error = rows[i].error(norm);
  const std::optional<double> before = i > 0 ? rows[i - 1].error(norm) : std::nullopt;
  return {error ? fmt::format("{:.3e}", *error) : "-",
          error && before ? fmt::format("{:.2f}", observed_order(*before, *error, rows[i - 1].cells,
                                                                 rows[i].cells))
                          : "-"};
}

void log_convergence(RunLog& log, const std::vector<ConvergenceRow>& rows) {
  std::vector<const char*> norms;
  for (const char* norm : {"L2", "H1", "eigenvalues"})
    if (std::ranges::any_of(rows, [&](const auto& row) { return row.error(norm).has_value(); }))
      norms.push_back(norm);
  std::string head = fmt::format("{:>7} {:>9}", "cells", "unknowns");
  for (const char* norm : norms) head += fmt::format(" {:>12} {:>6}", norm, "order");
  log.line("{}", head);
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const ConvergenceRow& row = rows[i];
    std::string text = fmt::format("{:>7} {:>9}", row.cells, row.unknowns);
    for (const char* norm : norms) {
      const auto [error, order] = error_texts(rows, i, norm);
      text += fmt::format(" {:>12} {:>6}", error, order);
    }
    if (!row.errors)
      text += fmt::format("   change of u in L2, relative: {}",
                          row.change ? fmt::format("{:.3e}", *row.change) : "-");
    log.line("{}", text);
  }
}

std::vector<ConvergenceRow> convergence_study(const ScalarProblem& problem,
                                              const std::vector<int>& cells) {
  std::vector<ConvergenceRow> rows;
  ScalarResults previous;
  for (const int count : cells) {
    const Grid grid = problem.grid(count);
    const ScalarSolution solution = problem.solve(grid);
    ConvergenceRow& row = rows.emplace_back(ConvergenceRow{count, solution.unknowns, {}, {}});
    row.eigenvalue_error = eigenvalue_error(problem, solution);
    if (const auto errors = solution_errors(problem, grid, solution))
      row.errors = errors->all;
    else if (rows.size() > 1)
      row.change = relative_change(solution, previous);
    previous = solution.results;
  }
  return rows;
}

void check_orders(RunReport& report, const ConvergenceCheck& check, RunLog& log) {
  const std::vector<ConvergenceRow>& rows = report.convergence;
  if (rows.size() < 2) return;
  const ConvergenceRow &coarse = rows[rows.size() - 2], &fine = rows.back();
  for (const OrderBounds& bounds : check.orders) {
    const std::optional<double> coarse_error = coarse.error(bounds.norm),
                                fine_error = fine.error(bounds.norm);
    if (!coarse_error || !fine_error) continue;
    const double order = observed_order(*coarse_error, *fine_error, coarse.cells, fine.cells);
    const bool ok = order >= bounds.least && order <= bounds.most.value_or(INFINITY);
    report.orders.push_back({bounds.norm, order, bounds, ok});
    log.line("order in {}: {:.3f}, expected {}: {}", bounds.norm, order,
             bounds.most ? fmt::format("{} to {}", bounds.least, *bounds.most)
                         : fmt::format("at least {}", bounds.least),
             ok ? "ok" : "MISSED");
  }
}

void check_expectations(RunReport& report, const Problem& problem,
                        const nlohmann::ordered_json& summary, RunLog& log) {
  for (const Expectation& expectation : problem.verification.expectations) {
    const auto value = find_quantity(summary, expectation.quantity);
    if (!value)
      throw ProblemFileErrors({Mistake{fmt::format("there is no result '{}'", expectation.quantity),
                                       expectation.place}});
    report.expectations.push_back(check(expectation, *value));
    const ExpectationResult& result = report.expectations.back();
    log.line("expect {}: {:.12g}, expected {:.12g}, error {:.1e}: {}", result.quantity,
             result.value, result.expected, result.relative_error, result.ok ? "ok" : "MISSED");
  }
}

}  // namespace

int run_problem(const std::string& file, const RunOptions& options) {
  const Stopwatch total;
  RunLog log(options.quiet || options.json);
  RunReport report;
  require_writable(options.output);
  const Problem problem = read_problem(file, options.overrides);
  report.seconds.read = total.seconds();

  const Stopwatch prepare;
  report.relations = answered(problem.relations, problem.bounds);
  const ScalarProblem scalar(problem);
  report.seconds.prepare = prepare.seconds();
  const Grid grid = scalar.grid();
  const ScalarSolution solution = scalar.solve(grid);
  report.seconds.quadrature = solution.seconds.quadrature;
  report.seconds.assembly = solution.seconds.assembly;
  report.seconds.solve = solution.seconds.solve;
  log_solution(log, scalar, grid, solution);

  for (const RelationAnswer& answer : report.relations)
    log.line("{}", relation_text(answer, problem.dimension));

  const Stopwatch verify;
  if (options.verify) report.errors = solution_errors(scalar, grid, solution);
  if (report.errors)
    for (const auto& [name, errors] : report.errors->by_unknown) log_errors(log, name, errors);
  if (options.verify) report.eigenvalue_error = eigenvalue_error(scalar, solution);
  if (report.eigenvalue_error)
    log.line("error of the eigenvalues, the largest, relative: {:.3e}", *report.eigenvalue_error);
  report.probes = evaluate_probes(scalar, solution);
  const auto& convergence = problem.verification.convergence;
  if (options.converge > 1) {
    int cells = 1;
    for (int axis = 0; axis < grid.dimension(); ++axis) cells = std::max(cells, grid.cells(axis));
    std::vector<int> doublings;
    for (int i = 0; i < options.converge; ++i, cells *= 2) doublings.push_back(cells);
    report.convergence = convergence_study(scalar, doublings);
  } else if (options.verify && convergence) {
    report.convergence = convergence_study(scalar, convergence->cells);
  }
  if (!report.convergence.empty()) log_convergence(log, report.convergence);
  if (options.verify && convergence && options.converge <= 1)
    check_orders(report, *convergence, log);
  report.seconds.verify = verify.seconds();

  const Stopwatch output;
  ResultFolder folder(options.output);
  const std::string name = std::filesystem::path(file).stem().string();
  const ResultMeshes meshes = result_meshes(scalar, grid, solution);
  folder.write(name + ".vtu", [&](const std::string& path) { write_vtu(meshes.volume, path); });
  if (meshes.boundary.cell_count() > 0)
    folder.write(name + ".boundary.vtu",
                 [&](const std::string& path) { write_vtu(meshes.boundary, path); });
  if (problem.outputs.rule)
    folder.write(name + ".rule.vtp",
                 [&](const std::string& path) { write_vtp(rule_points(solution.rule), path); });
  if (options.picture || problem.outputs.picture)
    report.notes = write_pictures(folder, name, scalar, solution, report.convergence);
  for (const std::string& note : report.notes) log.line("note: {}", note);
  if (const std::string csv = probes_csv(report.probes); !csv.empty())
    folder.write_text("probes.csv", csv);
  folder.write_text("input.resolved.yaml", document_text(problem.document));
  report.seconds.output = output.seconds();
  report.seconds.total = total.seconds();

  nlohmann::ordered_json summary = make_summary(scalar, solution, report);
  if (options.verify) {
    check_expectations(report, problem, summary, log);
    add_expectations(summary, report);
  }
  log.line("{:.2f} s; results in {}", report.seconds.total, folder.path());
  folder.write_text("summary.json", json_text(summary) + "\n");
  folder.write_text("log.txt", log.text());
  folder.commit();
  if (options.json) std::puts(json_text(summary).c_str());
  return report.all_ok() ? 0 : 1;
}

}  // namespace rfm
