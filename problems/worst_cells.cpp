#include "problems/worst_cells.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "quadrature/divergence_defects.hpp"

namespace rfm {

std::vector<WorstCell> worst_cells(const DomainRule& rule, int count) {
  const std::vector<double> defects = divergence_defects(rule);
  const std::vector<CellReport>& reports = rule.report().cells;
  double side = 0;
  for (int axis = 0; axis < rule.dimension(); ++axis)
    side = std::max(side, rule.grid().largest_width(axis));
  const auto concern = [&](int i) {
    const CellReport& cell = reports[i];
    return cell.uncertified.measure + cell.order_difference.volume + defects[i] +
           side * (cell.uncertified.boundary + cell.order_difference.boundary);
  };
  std::vector<int> worst;
  const double least = 1e-13 * rule.measure();
  for (int i = 0; i < static_cast<int>(reports.size()); ++i)
    if (concern(i) > least) worst.push_back(i);
  const int kept = std::min(count, static_cast<int>(worst.size()));
  std::ranges::partial_sort(worst, worst.begin() + kept, std::greater<>(), concern);
  worst.resize(kept);
  std::vector<WorstCell> result;
  for (const int i : worst) {
    const std::array<int, 3> position = rule.grid().position(reports[i].cell);
    Point center = rule.grid().cell(position).center();
    for (double& x : center)
      if (std::fabs(x) < 1e-12 * side) x = 0;
    result.push_back({reports[i], defects[i], position, center});
  }
  return result;
}

nlohmann::ordered_json as_json(const std::vector<WorstCell>& cells, int dimension) {
  nlohmann::ordered_json result = nlohmann::ordered_json::array();
  for (const WorstCell& cell : cells) {
    const auto coordinates = [&](const auto& values) {
      return std::vector(values.begin(), values.begin() + dimension);
    };
    result.push_back({{"cell", coordinates(cell.position)},
                      {"center", coordinates(cell.center)},
                      {"order_difference",
                       {{"domain", cell.report.order_difference.volume},
                        {"boundary_total", cell.report.order_difference.boundary}}},
                      {"divergence_defect", cell.divergence_defect},
                      {"uncertified_measure", cell.report.uncertified.measure},
                      {"uncertified_boundary", cell.report.uncertified.boundary}});
  }
  return result;
}

std::string as_text(const WorstCell& cell, int dimension) {
  const auto join = [&](const auto& values, const char* format) {
    std::string text;
    for (int axis = 0; axis < dimension; ++axis)
      text += (axis > 0 ? ", " : "") + fmt::format(fmt::runtime(format), values[axis]);
    return text;
  };
  std::string text = fmt::format(
      "cell ({}) around ({}): orders differ by {:.1e}, on the boundary by {:.1e}; "
      "divergence theorem {:.1e}",
      join(cell.position, "{}"), join(cell.center, "{:.4g}"), cell.report.order_difference.volume,
      cell.report.order_difference.boundary, cell.divergence_defect);
  if (cell.report.uncertified.boxes > 0)
    text += fmt::format("; best effort in {:.1e}", cell.report.uncertified.measure);
  return text;
}

}  // namespace rfm
