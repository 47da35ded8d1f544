#pragma once

#include <nlohmann/json.hpp>

#include "quadrature/domain_rule.hpp"

namespace rfm {

/// A cell in which the rule is less accurate than in others.
struct WorstCell {
  CellReport report;
  /// See `divergence_defects`.
  double divergence_defect = 0;
  std::array<int, 3> position{};  ///< of the cell along each axis, from 0
  Point center{};
};

/// The cells that are worst, the worst first, at most `count`: by the sum of what is uncertified,
/// of the differences of orders and of the defect of the divergence theorem, boundaries times the
/// side of a cell. Cells exact to 1e-13 of the domain are none.
std::vector<WorstCell> worst_cells(const DomainRule& rule, int count);

/// `trust.worst_cells` of summaries.
nlohmann::ordered_json as_json(const std::vector<WorstCell>& cells, int dimension);

/// One line for `check`.
std::string as_text(const WorstCell& cell, int dimension);

}  // namespace rfm
