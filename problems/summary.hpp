#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "problems/geometric_relations.hpp"
#include "problems/probe_evaluation.hpp"
#include "problems/verification.hpp"

namespace rfm {

/// Everything that a run found out: what `summary.json` is rendered from.
struct RunReport {
  std::optional<ErrorReport> errors;
  std::optional<double> eigenvalue_error;  ///< the largest, relative
  std::vector<ProbeResult> probes;
  std::vector<RelationAnswer> relations;
  std::vector<ConvergenceRow> convergence;
  struct OrderCheck {
    std::string norm;
    double order = 0;
    OrderBounds bounds;
    bool ok = false;
  };
  std::vector<OrderCheck> orders;
  std::vector<ExpectationResult> expectations;
  std::vector<std::string> notes;  ///< on the pictures
  struct Seconds {
    double read = 0, prepare = 0, quadrature = 0, assembly = 0, solve = 0, verify = 0, output = 0,
           total = 0;
  } seconds;

  /// Whether every expectation and order holds.
  bool all_ok() const;
};

/// The version of this program.
std::string version();

/// `summary.json` as in the contract of result files, expectations excepted: they look their
/// quantities up in it, and `add_expectations` adds them.
nlohmann::ordered_json make_summary(const ScalarProblem& problem, const ScalarSolution& solution,
                                    const RunReport& report);
void add_expectations(nlohmann::ordered_json& summary, const RunReport& report);

/// The values of line probes, one per row: probe, x, y, z, quantity, value. Points outside the
/// domain have no rows. Empty without line probes.
std::string probes_csv(const std::vector<ProbeResult>& probes);

}  // namespace rfm
