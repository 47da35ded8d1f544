// Where the undetermined functions of a problem live: their splines, and windows with finer ones.

#include <fmt/format.h>

#include "core/error.hpp"
#include "problems/function_support.hpp"
#include "problems/problem_forms.hpp"
#include "problems/scalar_problem.hpp"
#include "solvers/assembly.hpp"
#include "solvers/refined_splines.hpp"

namespace rfm {

void ScalarProblem::add_windows(int& functions) {
  windows_ = rfm::windows(problem_, grid(), bounds_, unknown_count(), functions);
  for (const Window& window : windows_) {
    for (int c = 0; c < unknown_count(); ++c)
      structures_[c] = structures_[c] + plans_[c].weight.function * window.factor *
                                            Structure::undetermined(window.function + c);
    plans_[0].remarks.push_back(
        fmt::format("window '{}': cells {} times smaller, solved {}", window.option.shape,
                    window.finer, window.option.global ? "with the domain" : "after the domain"));
  }
}

void ScalarProblem::check_windows() const {
  using Method = Discretization::Method;
  const Method method = problem_.discretization.method;
  for (const WindowOption& window : inner_.windows) {
    const auto refuse = [&](const char* message) {
      throw ProblemFileErrors({Mistake{message, window.place}});
    };
    if (has_global_functions()) refuse("windows are those of splines");
    if (!plans_[0].own_structure.empty()) refuse("windows do not go with a structure of one's own");
    if (!natural_.empty()) refuse("windows do not go with fluxes by structure");
    if (!periodic_.empty()) refuse("windows do not go with periodic sides");
    if (problem_.discretization.extension) refuse("windows do not go with extended splines");
    if (method == Method::collocation || must_use_qr())
      refuse(
          "windows are for the methods of Ritz and Galerkin and for least squares by normal "
          "equations");
    if (window.smoothness < 1 && (problem_.physics.custom || method == Method::least_squares))
      refuse("equations with second derivatives need a smoothness of 1 at least");
    if (!window.global && (uses_forms(*this) || problem_.study.type == Study::Type::eigen))
      refuse(
          "after the domain windows are solved in linear, steady problems by Ritz's method: "
          "solve: global");
  }
}

int ScalarProblem::function_degree(int function) const {
  return rfm::function_degree(*this, function);
}

std::vector<std::vector<std::uint8_t>> ScalarProblem::function_cells(const DomainRule& rule) const {
  // Cells are left out by the degree of all, so that unknowns live on the same ones.
  const std::vector<std::uint8_t> cells = cells_in_region(rule, problem_.discretization.degree);
  std::vector<std::vector<std::uint8_t>> result(unknown_count(), cells);
  if (function_count() == unknown_count()) return result;
  const std::vector<Structure> list = structures(rule.grid());
  for (int function = unknown_count(); function < function_count(); ++function)
    result.push_back(cells_of_function(function, list, rule, cells));
  return result;
}

std::vector<TensorProductSpace> ScalarProblem::spaces(const DomainRule& rule) const {
  std::vector<TensorProductSpace> result;
  for (const std::vector<std::uint8_t>& cells : function_cells(rule))
    result.emplace_back(rule.grid(), function_degree(static_cast<int>(result.size())), cells);
  return result;
}

// The same functions on grids of their own.
std::vector<TensorProductSpace> ScalarProblem::own_spaces(const DomainRule& rule,
                                                          const Grid& grid) const {
  std::vector<TensorProductSpace> result;
  for (const std::vector<std::uint8_t>& cells : function_cells(rule)) {
    const int function = static_cast<int>(result.size());
    Grid own = grid;
    for (const Window& window : windows_)
      if (function >= window.function && function < window.function + unknown_count())
        own = window_grid(window, grid);
    result.push_back(own_space(own, rule.grid(), function_degree(function), cells));
  }
  return result;
}

bool ScalarProblem::solves_in_turn() const {
  return std::ranges::any_of(windows_, [](const Window& window) { return !window.option.global; });
}

// The functions of the domain and of windows that are solved with it, then each other window.
std::vector<Eigen::Index> ScalarProblem::blocks(const SplineExtraction& extraction) const {
  std::vector<Eigen::Index> first{0};
  for (const Window& window : windows_)
    if (!window.option.global) first.push_back(extraction.first[window.function]);
  first.push_back(extraction.matrix.cols());
  return first;
}

}  // namespace rfm
