#include "quadrature/polygon_division.hpp"

#include <limits>

#include "core/point_algebra.hpp"

namespace rfm {
namespace {

class PolygonDivision {
 public:
  PolygonDivision(const std::vector<int>& polygon, const std::vector<unsigned>& sides,
                  const std::vector<Point>& vertices)
      : polygon_(polygon),
        sides_(sides),
        vertices_(vertices),
        cost_(polygon.size() * polygon.size(), 0.0),
        split_(polygon.size() * polygon.size(), 0) {
    const std::size_t count = polygon.size();
    for (std::size_t span = 2; span < count; ++span)
      for (std::size_t i = 0; i + span < count; ++i) {
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = i + 1; k < i + span; ++k) {
          const double cost =
              cost_[index(i, k)] + cost_[index(k, i + span)] + corner_cost(i, k, i + span);
          if (cost < least) {
            least = cost;
            split_[index(i, i + span)] = k;
          }
        }
        cost_[index(i, i + span)] = least;
      }
  }

  void append(int primitive, std::vector<Facet>& facets) const {
    append(0, polygon_.size() - 1, primitive, facets);
  }

 private:
  std::size_t index(std::size_t i, std::size_t j) const { return i * polygon_.size() + j; }

  double corner_cost(std::size_t a, std::size_t b, std::size_t c) const {
    constexpr double forbidden = 1e6;
    const Point &p = vertices_[polygon_[a]], &q = vertices_[polygon_[b]],
                &r = vertices_[polygon_[c]];
    const double around = norm(difference(p, q)) + norm(difference(q, r)) + norm(difference(r, p));
    return (sides_[a] & sides_[b] & sides_[c]) != 0 ? forbidden * around : around;
  }

  void append(std::size_t i, std::size_t j, int primitive, std::vector<Facet>& facets) const {
    if (j - i < 2) return;
    const std::size_t k = split_[index(i, j)];
    facets.push_back({{polygon_[i], polygon_[k], polygon_[j]}, primitive});
    append(i, k, primitive, facets);
    append(k, j, primitive, facets);
  }

  const std::vector<int>& polygon_;
  const std::vector<unsigned>& sides_;
  const std::vector<Point>& vertices_;
  std::vector<double> cost_;
  std::vector<std::size_t> split_;
};

}  // namespace

void divide_polygon(const std::vector<int>& polygon, const std::vector<unsigned>& sides,
                    const std::vector<Point>& vertices, int primitive, std::vector<Facet>& facets) {
  PolygonDivision(polygon, sides, vertices).append(primitive, facets);
}

}  // namespace rfm
