#include "problems/function_support.hpp"

#include <algorithm>
#include <cmath>

#include "core/tape.hpp"

namespace rfm {
namespace {

constexpr double negligible = 1e-6;

// The largest absolute value of each root at a cell's points.
class LargestFactors {
 public:
  LargestFactors(const std::vector<Field>& factors, const DomainRule& rule)
      : tape_(factors, {0}, rule.dimension()), workspace_(tape_), rule_(rule) {}

  std::vector<double> of_inside_cell(int cell) {
    VolumePoints points;
    rule_.add_inside_points(cell, points);
    return largest(points, {0, points.size()});
  }
  std::vector<double> of_cut_cell(int i) { return largest(rule_.cut_points(), rule_.cut_range(i)); }

 private:
  std::vector<double> largest(const VolumePoints& points, PointRange range) {
    std::vector<double> result(static_cast<std::size_t>(tape_.root_count()), 0.0);
    for (int begin = range.begin; begin < range.end; begin += Tape::block_size) {
      PointBlock block;
      block.count = std::min<int>(Tape::block_size, range.end - begin);
      for (int axis = 0; axis < rule_.dimension(); ++axis)
        block.coordinates[axis] = points.coordinates[axis].data() + begin;
      tape_.evaluate(block, workspace_);
      for (std::size_t root = 0; root < result.size(); ++root)
        for (int i = 0; i < block.count; ++i)
          result[root] =
              std::max(result[root], std::fabs(workspace_.coefficient(static_cast<int>(root))[i]));
    }
    return result;
  }

  Tape tape_;
  Tape::Workspace workspace_;
  const DomainRule& rule_;
};

}  // namespace

std::vector<std::uint8_t> cells_of_function(int function, std::span<const Structure> structures,
                                            const DomainRule& rule,
                                            std::vector<std::uint8_t> cells) {
  std::vector<Field> factors;
  for (const Structure& structure : structures)
    for (const Structure::Term& term : structure.terms())
      if (term.unknown == function) factors.push_back(term.coefficient);
  if (factors.empty()) return cells;
  LargestFactors factors_in(factors, rule);
  std::vector<std::pair<int, std::vector<double>>> found;
  for (const int cell : rule.inside_cells())
    found.emplace_back(cell, factors_in.of_inside_cell(cell));
  for (std::size_t i = 0; i < rule.cut_cells().size(); ++i)
    found.emplace_back(rule.cut_cells()[i], factors_in.of_cut_cell(static_cast<int>(i)));
  std::vector<double> largest(factors.size(), 0.0);
  for (const auto& [cell, values] : found)
    for (std::size_t k = 0; k < values.size(); ++k) largest[k] = std::max(largest[k], values[k]);
  std::vector<std::uint8_t> result(cells.size(), 0);
  bool is_any = false;
  for (const auto& [cell, values] : found)
    for (std::size_t k = 0; k < values.size(); ++k)
      if (values[k] > negligible * largest[k] && cells[cell]) result[cell] = 1, is_any = true;
  return is_any ? result : cells;
}

}  // namespace rfm
