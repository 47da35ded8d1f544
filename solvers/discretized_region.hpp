#pragma once

#include <optional>

#include "basis/tensor_product_space.hpp"
#include "core/region.hpp"
#include "core/weight.hpp"
#include "quadrature/domain_rule.hpp"

namespace rfm {

struct DiscretizationOptions {
  int cells = 64;  ///< along the longest side of the grid
  int degree = 3;  ///< of the splines; errors are O(h^(degree + 1)) where solutions are smooth
  /// The box of the grid; without it, the bounding box of the region.
  std::optional<Box> grid{};
};

/// A region with all that approximation over it needs: a background grid that knows nothing of its
/// shape, quadrature inside and on the boundary (degree + 1 points per axis in cells inside,
/// degree + 3 in cut cells and on boundaries), and splines.
///
///     const DiscretizedRegion domain(circle({0, 0}, 1) - circle({0.2, 0.1}, 0.4), {.cells = 48});
///     const double area = domain.rule().measure();
class DiscretizedRegion {
 public:
  /// Throws `InvalidArgument` if the region is empty or unbounded, or the options make no grid.
  explicit DiscretizedRegion(const Region& region, const DiscretizationOptions& options = {});

  int dimension() const { return evaluator_.dimension(); }
  const RegionEvaluator& evaluator() const { return evaluator_; }
  const Box& bounds() const { return bounds_; }
  const Grid& grid() const { return rule_.grid(); }
  const DomainRule& rule() const { return rule_; }
  /// The splines whose support meets the region.
  const TensorProductSpace& space() const { return space_; }
  /// ω, zero on the boundary and positive inside, in the smoothest form that is right
  /// (core/weight.hpp).
  Weight weight() const { return rfm::weight(evaluator_, bounds_); }

 private:
  RegionEvaluator evaluator_;
  Box bounds_;
  DomainRule rule_;
  TensorProductSpace space_;
};

}  // namespace rfm
