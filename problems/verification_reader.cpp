#include "problems/run_reader.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/nearest_name.hpp"
#include "problems/result_scope.hpp"

namespace rfm {

void read_verification(const DocumentNode& root, ValueReader& values, Problem& problem) {
  const DocumentNode* map = values.find(root, "verify");
  if (!map) return;
  Verification& verification = problem.verification;
  if (const DocumentNode* exact = values.find(*map, "exact"))
    for (const DocumentNode::Entry& entry : exact->entries) {
      const std::vector<std::string>& unknowns = problem.physics.unknowns;
      if (std::ranges::find(unknowns, entry.key) == unknowns.end()) {
        values.mistakes.add(fmt::format("unknown result '{}' in exact; expected: {}", entry.key,
                                        fmt::join(unknowns, ", ")),
                            entry.key_place);
        continue;
      }
      if (const std::optional<Field> field = values.field(entry.value))
        verification.exact.emplace(entry.key, *field);
    }
  if (const DocumentNode* exact = values.find(*map, "eigenvalues")) {
    verification.eigenvalues = values.numbers(*exact).value_or(std::vector<double>{});
    if (problem.study.type != Study::Type::eigen)
      values.mistakes.add("eigenvalues need study: {type: eigen}", exact->place);
    else if (verification.eigenvalues.size() > static_cast<std::size_t>(problem.study.count))
      values.mistakes.add(fmt::format("{} eigenvalues are more than the study's count of {}",
                                      verification.eigenvalues.size(), problem.study.count),
                          exact->place);
  }
  const auto check_quantity = [&](const DocumentNode& node) {
    constexpr std::array<std::string_view, 19> parts = {"probes",
                                                        "errors",
                                                        "measures",
                                                        "energy",
                                                        "unknowns",
                                                        "cells",
                                                        "seconds",
                                                        "eigenvalues",
                                                        "frequencies",
                                                        "factors",
                                                        "convergence",
                                                        "boundary_residual",
                                                        "estimated_error",
                                                        "peak_memory_mb",
                                                        "trust",
                                                        "relations",
                                                        "newton",
                                                        "modes",
                                                        "angular_frequencies"};
    const std::string first = node.text.substr(0, node.text.find_first_of(".["));
    const std::vector<std::string> known(parts.begin(), parts.end());
    if (std::ranges::find(known, first) == known.end())
      return values.mistakes.add("unknown quantity '" + first + "'" + did_you_mean(first, known),
                                 node.place_within(0, first.size()));
    if (first != "probes" || node.text.size() <= first.size() + 1) return;
    const std::string rest = node.text.substr(first.size() + 1);
    const std::string probe = rest.substr(0, rest.find_first_of(".["));
    std::vector<std::string> probes;
    for (const Probe& candidate : problem.probes) {
      probes.push_back(candidate.name);
      if (candidate.kind == Probe::Kind::max || candidate.kind == Probe::Kind::min)
        probes.push_back(candidate.name + "_at");
    }
    if (std::ranges::find(probes, probe) == probes.end())
      values.mistakes.add("unknown probe '" + probe + "'" + did_you_mean(probe, probes),
                          node.place_within(first.size() + 1, probe.size()));
  };
  if (const DocumentNode* expect = values.find(*map, "expect"))
    for (const DocumentNode& item : expect->items) {
      if (!values.fits(item)) continue;
      Expectation expectation;
      expectation.place = item.place;
      if (const DocumentNode* quantity = values.find(item, "quantity")) {
        expectation.quantity = quantity->text;
        check_quantity(*quantity);
      }
      if (const DocumentNode* value = values.find(item, "value"))
        expectation.value = values.number(*value).value_or(0);
      if (const DocumentNode* tolerance = values.find(item, "tolerance"))
        expectation.tolerance = values.number(*tolerance);
      if (const DocumentNode* tolerance = values.find(item, "relative_tolerance"))
        expectation.relative_tolerance = values.number(*tolerance);
      if (!item.find("tolerance") && !item.find("relative_tolerance"))
        values.mistakes.add("an expectation needs a tolerance or a relative_tolerance", item.place);
      verification.expectations.push_back(std::move(expectation));
    }
  const DocumentNode* convergence = values.find(*map, "convergence");
  if (!convergence) return;
  if (problem.discretization.basis != Discretization::Basis::bspline)
    values.mistakes.add(
        "grids of several sizes need splines: functions of the whole domain have a "
        "degree only",
        convergence->place);
  ConvergenceCheck check;
  if (const DocumentNode* cells = values.find(*convergence, "cells")) {
    check.cells = values.integers(*cells).value_or(std::vector<int>{});
    if (cells->items.size() < 2)
      values.mistakes.add("an order of convergence needs two grids or more", cells->place);
    if (std::ranges::adjacent_find(check.cells, std::greater_equal<>()) != check.cells.end())
      values.mistakes.add("the cells must increase from grid to grid", cells->place);
  }
  for (const char* norm : {"L2", "H1", "max", "eigenvalues"}) {
    if (const DocumentNode* least = values.find(*convergence, "minimum_order"))
      if (const DocumentNode* order = values.find(*least, norm))
        if (const std::optional<double> value = values.number(*order))
          check.orders.push_back({norm, *value, {}});
    if (const DocumentNode* both = values.find(*convergence, "order"))
      if (const DocumentNode* order = values.find(*both, norm)) {
        const auto bounds = values.numbers(*order);
        if (bounds && bounds->size() == 2)
          check.orders.push_back({norm, (*bounds)[0], (*bounds)[1]});
        else if (bounds)
          values.mistakes.add("expected two numbers [least, most]", order->place);
      }
  }
  const auto needs = [&](const char* key, bool eigenvalues) {
    const bool given = map->find(key) != nullptr;
    if (!given && std::ranges::any_of(check.orders, [&](const OrderBounds& order) {
          return (order.norm == "eigenvalues") == eigenvalues;
        }))
      values.mistakes.add(fmt::format("orders of convergence need the exact {}: add verify.{}",
                                      eigenvalues ? "eigenvalues" : "solution", key),
                          convergence->place);
  };
  needs("exact", false);
  needs("eigenvalues", true);
  verification.convergence = std::move(check);
}

}  // namespace rfm
