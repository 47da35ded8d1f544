#include "solvers/discretized_region.hpp"

#include "core/bounding_box.hpp"
#include "solvers/assembly.hpp"

namespace rfm {
namespace {

DomainRule rule_over(const RegionEvaluator& region, const Box& box,
                     const DiscretizationOptions& options) {
  QuadratureOptions points;
  points.inside_points = options.degree + 1;
  points.cut_points = options.degree + 3;
  return make_domain_rule(region, Grid::with_square_cells(box, options.cells), points);
}

}  // namespace

DiscretizedRegion::DiscretizedRegion(const Region& region, const DiscretizationOptions& options)
    : evaluator_(region),
      bounds_(bounding_box(evaluator_)),
      rule_(rule_over(evaluator_, options.grid.value_or(bounds_), options)),
      space_(rule_.grid(), options.degree, cells_in_region(rule_, options.degree)) {}

}  // namespace rfm
