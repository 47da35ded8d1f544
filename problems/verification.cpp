#include "problems/verification.hpp"

#include <charconv>
#include <cmath>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "solvers/integrate.hpp"

namespace rfm {

double SolutionErrors::by_name(const std::string& norm) const {
  if (norm == "L2") return l2;
  if (norm == "H1") return h1;
  if (norm == "max") return maximum;
  throw InvalidArgument("there is no norm '" + norm + "'; expected L2, H1 or max");
}

namespace {

SolutionErrors errors_of(const FieldNorms& error, const FieldNorms& size) {
  const auto relative = [](double part, double whole) { return whole > 0 ? part / whole : part; };
  SolutionErrors errors;
  errors.l2 = error.l2;
  errors.l2_relative = relative(error.l2, size.l2);
  errors.h1 = error.h1_seminorm;
  errors.h1_relative = relative(error.h1_seminorm, size.h1_seminorm);
  errors.maximum = error.maximum;
  return errors;
}

void add_component(FieldNorms& sum, const FieldNorms& part) {
  sum.l2 = std::hypot(sum.l2, part.l2);
  sum.h1_seminorm = std::hypot(sum.h1_seminorm, part.h1_seminorm);
  sum.maximum = std::max(sum.maximum, part.maximum);
}

}  // namespace

std::optional<ErrorReport> solution_errors(const ScalarProblem& problem, const Grid& grid,
                                           const ScalarSolution& solution) {
  const std::map<std::string, Field>& exact = problem.problem().verification.exact;
  if (exact.empty()) return std::nullopt;
  const DomainRule rule = problem.rule(grid, 2);
  ErrorReport report;
  FieldNorms all_error, all_size;
  for (const auto& [name, field] : solution.results.unknowns) {
    const auto known = exact.find(name);
    if (known == exact.end()) continue;
    const Field difference = field - known->second;
    FieldNorms error = norms(difference, rule);
    const FieldNorms size = norms(known->second, rule);
    error.maximum =
        std::max(error.maximum, maximum(difference, rule, {Contribution::Place::boundary}));
    report.by_unknown.emplace_back(name, errors_of(error, size));
    add_component(all_error, error);
    add_component(all_size, size);
  }
  report.all = errors_of(all_error, all_size);
  return report;
}

std::optional<double> ConvergenceRow::error(const std::string& norm) const {
  if (norm == "eigenvalues") return eigenvalue_error;
  return errors ? std::optional(errors->by_name(norm)) : std::nullopt;
}

double observed_order(double coarse_error, double fine_error, int coarse_cells, int fine_cells) {
  return std::log(coarse_error / fine_error) / std::log(double(fine_cells) / coarse_cells);
}

std::optional<double> find_quantity(const nlohmann::ordered_json& summary,
                                    const std::string& path) {
  if (summary.is_number() && path.empty()) return summary.get<double>();
  if (summary.is_null() && path.empty()) return std::nan("");  // JSON has no NaN
  if (summary.is_array() && path.starts_with('[')) {
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(path.data() + 1, path.data() + path.size(), index);
    if (error != std::errc() || end == path.data() + path.size() || *end != ']') return {};
    if (index >= summary.size()) return {};
    std::string rest(end + 1, path.data() + path.size());
    if (rest.starts_with('.')) rest.erase(0, 1);
    return find_quantity(summary[index], rest);
  }
  if (!summary.is_object()) return {};
  // The longest key that the path begins with, so that texts with dots may be keys.
  std::optional<double> found;
  std::size_t longest = 0;
  for (const auto& [key, value] : summary.items()) {
    if (!path.starts_with(key) || (found && key.size() <= longest)) continue;
    std::string rest = path.substr(key.size());
    if (rest.starts_with('.'))
      rest.erase(0, 1);
    else if (!rest.empty() && !rest.starts_with('['))
      continue;
    if (const auto number = find_quantity(value, rest)) {
      found = number;
      longest = key.size();
    }
  }
  return found;
}

ExpectationResult check(const Expectation& expectation, double value) {
  ExpectationResult result{expectation.quantity, value, expectation.value, 0, false};
  const double absolute = std::fabs(value - expectation.value);
  result.relative_error =
      expectation.value != 0 ? absolute / std::fabs(expectation.value) : absolute;
  result.ok = (expectation.tolerance && absolute <= *expectation.tolerance) ||
              (expectation.relative_tolerance &&
               absolute <= *expectation.relative_tolerance * std::fabs(expectation.value));
  return result;
}

}  // namespace rfm
