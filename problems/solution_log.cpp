#include "problems/solution_log.hpp"

#include <algorithm>

#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// The structure as text; what is very long stands whole in the summary.
void log_line_of_structure(RunLog& log, std::string_view name,
                           const std::optional<std::string>& line) {
  constexpr std::size_t longest = 1000;
  if (!line)
    log.line("  it cannot be written as one line");
  else if (line->size() <= longest)
    log.line("  {}: {}", name, *line);
  else
    log.line("  {}: {}... (the whole stands in summary.json)", name, line->substr(0, longest / 2));
}

void log_structure(RunLog& log, const std::string& unknown, const DirichletPlan& plan,
                   const std::optional<std::string>& line) {
  if (!plan.own_structure.empty())
    log.line("structure: {} = {}", unknown, plan.own_structure);
  else if (plan.interpolated_sets > 0)
    log.line("{} interpolates the data of {} sets", unknown, plan.interpolated_sets);
  else if (!plan.by_structure.empty())
    log.line("structure: {} = g + omega psi, omega = {}", unknown, plan.weight.formula);
  else
    log.line("structure: {} = psi", unknown);
  if (plan.own_structure.empty())
    log_line_of_structure(log, plan.interpolated_sets > 0 ? unknown : "discretization.structure",
                          line);
  if (plan.data_sets.size() > 1)
    for (const auto& set : plan.data_sets)
      log.line("  g takes the data of {} where {} = 0", set.pieces, set.distance);
  for (const std::string& remark : plan.remarks) log.line("note: {}", remark);
}

void log_newton(RunLog& log, const ScalarSolution& solution) {
  if (solution.newton.empty()) return;
  log.line("{:>6} {:>12} {:>12} {:>8}", "Newton", "residual", "step", "damping");
  for (std::size_t i = 0; i < solution.newton.size(); ++i) {
    const NewtonIteration& iteration = solution.newton[i];
    log.line("{:>6} {:>12.3e} {:>12.3e} {:>8.3g}", i + 1, iteration.residual, iteration.step,
             iteration.damping);
  }
  if (solution.newton_order)
    log.line("order of convergence of the last steps: {:.2f}", *solution.newton_order);
}

void log_eigenvalues(RunLog& log, const EigenResult& eigen, const Study& study) {
  log.line("eigenvalues from {:.6g}: all of the {} below {:.6g} are known, by the signs of pivots",
           study.shift, eigen.present, eigen.upper);
  log.line("{:>4} {:>22} {:>18} {:>9}", "mode", "eigenvalue", "frequency", "residual");
  const std::vector<double> frequencies = eigen.frequencies();
  for (std::size_t i = 0; i < eigen.values.size(); ++i)
    log.line("{:>4} {:>22.14g} {:>18.12g} {:>9.1e}", i + 1, eigen.values[i], frequencies[i],
             eigen.residuals[i]);
}

}  // namespace

void log_solution(RunLog& log, const ScalarProblem& problem, const Grid& grid,
                  const ScalarSolution& solution) {
  const QuadratureReport& quadrature = solution.rule.report();
  if (!problem.problem().title.empty()) log.line("{}", problem.problem().title);
  const std::vector<DirichletPlan>& plans = problem.dirichlet();
  const std::vector<std::optional<std::string>> lines = problem.structure_lines(grid);
  for (std::size_t c = 0; c < plans.size(); ++c)
    log_structure(log, problem.problem().physics.unknowns[c], plans[c], lines[c]);
  if (const std::string note = bounds_note(problem); !note.empty()) log.line("note: {}", note);
  // A zero inside matters to a weight only.
  for (const Irregularity& irregularity : problem.irregularities())
    if (irregularity.kind == Irregularity::Kind::dangling || problem.has_irregular_weight())
      log.line("note: {}", describe(irregularity, problem.region()));
  if (solution.mean_set_to_zero)
    log.line("note: nothing fixes {}; its mean is set to zero",
             problem.problem().physics.custom ? "a level or a rigid motion" : "the level of u");
  std::string cells;
  for (int axis = 0; axis < grid.dimension(); ++axis)
    cells += fmt::format("{}{}", axis > 0 ? " x " : "", grid.cells(axis));
  for (int axis = 0; !grid.is_uniform() && axis < grid.dimension(); ++axis)
    cells += fmt::format("{}{:.3g} to {:.3g}", axis > 0 ? " x " : " (", grid.smallest_width(axis),
                         grid.largest_width(axis));
  if (!grid.is_uniform()) cells += ")";
  const Discretization& discretization = problem.problem().discretization;
  log.line("{}: {} cells, degree {}: {} inside, {} cut (smallest part {:.1e}), {} unknowns",
           discretization.basis == Discretization::Basis::bspline
               ? "grid"
               : "functions of the whole domain, integrated on",
           cells, discretization.degree, quadrature.inside_cells, quadrature.cut_cells,
           quadrature.smallest_cut_fraction, solution.unknowns);
  for (const std::string& note : solution.notes)
    log.line("{}{}", note.starts_with("warning") ? "" : "note: ", note);
  if (quadrature.uncertified.boxes > 0)
    log.line(
        "note: quadrature is a best effort in {} boxes of total measure {:.1e}, with "
        "{:.1e} of the boundary",
        quadrature.uncertified.boxes, quadrature.uncertified.measure,
        quadrature.uncertified.boundary);
  log.line("measures: domain {:.12g}, boundary {:.12g}; divergence theorem holds to {:.1e}",
           solution.rule.measure(), solution.rule.boundary_measure(), quadrature.divergence_defect);
  if (solution.eigen) {
    log_eigenvalues(log, *solution.eigen, problem.problem().study);
    log.line("boundary residual of the modes, of unit mass: {:.1e}", solution.boundary_residual);
    return;
  }
  if (problem.problem().physics.type == PhysicsType::interpolation) {
    log.line("values are missed by {:.1e}", solution.boundary_residual);
    return;
  }
  if (solution.linearity == Linearity::by_value)
    log.line(
        "note: the equations are linear by their values, though not by their formulas: one system, "
        "and the residual at its solution is that of a linear problem");
  log_newton(log, solution);
  log.line("solved: linear residual {:.1e}, boundary residual {:.1e}{}",
           solution.linear.relative_residual, solution.boundary_residual,
           solution.energy ? fmt::format(", energy {:.12g}", *solution.energy) : "");
  double largest_value = 0;  // of the data, and of the solution where these are 0
  bool has_weak_values = false;
  for (const DirichletPlan& plan : plans)
    for (const PieceCondition& condition : plan.weakly) {
      has_weak_values = true;
      largest_value =
          std::max({largest_value,
                    maximum(condition.data[0], solution.rule,
                            {Contribution::Place::boundary, {condition.primitive}}),
                    maximum(solution.results.unknowns[condition.component].field, solution.rule)});
    }
  if (has_weak_values && solution.boundary_residual > 1e-2 * largest_value)
    log.line(
        "note: values enforced weakly are missed by up to {:.2g}: the grid is too coarse there",
        solution.boundary_residual);
  if (solution.linear.method == LinearSolution::Method::ldlt && !has_weak_values)
    log.line(
        "note: the energy is not positive definite (a negative coefficient?); u is stationary");
  if (solution.undetermined && *solution.undetermined > 1e-4)
    log.line(
        "warning: the equations leave a part of the solution open, {:.1g} of it in a trial: is a "
        "condition missing?",
        *solution.undetermined);
  if (solution.linear.dropped > 0)
    log.line("note: {} splines without support were dropped", solution.linear.dropped);
}

}  // namespace rfm
