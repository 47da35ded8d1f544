#pragma once

#include <span>
#include <vector>

#include "quadrature/domain_rule.hpp"
#include "solvers/integrand_values.hpp"

namespace rfm {

/// The points of a rule by the number of their cell.
class CellPointIndex {
 public:
  /// Refers to `rule`.
  explicit CellPointIndex(const DomainRule& rule);

  PointRange cut_range(int cell) const { return cut_[cell]; }
  /// Points of the surface of a place (boundary or interface) in a cell.
  PointRange surface_range(Contribution::Place place, int cell) const {
    const std::vector<PointRange>& ranges =
        place == Contribution::Place::boundary ? boundary_ : interfaces_;
    return ranges.empty() ? PointRange{} : ranges[cell];
  }

  /// Appends the points of a cell inside, x running fastest.
  void add_inside(int cell, IntegrandPoints& points) const;
  void add_cut(PointRange range, IntegrandPoints& points) const;
  /// Appends points of a surface with their normals, those of the given numbers only (all if there
  /// are none).
  void add_surface(Contribution::Place place, PointRange range, std::span<const int> numbers,
                   IntegrandPoints& points) const;

 private:
  const DomainRule& rule_;
  GaussRule inside_rule_;
  std::vector<PointRange> cut_, boundary_, interfaces_;
};

}  // namespace rfm
