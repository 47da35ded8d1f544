#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/tape.hpp"
#include "problems/inner_structure.hpp"
#include "solution_structures/singular_functions.hpp"

namespace rfm {
namespace {

constexpr double pi = std::numbers::pi;
constexpr std::size_t automatic_count = 3;

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

// A straight side of the boundary that begins at a point.
struct Ray {
  double angle = 0;
  int primitive = 0;
};

class Surroundings {
 public:
  Surroundings(const Point& vertex, const RegionEvaluator& region, const DomainRule& rule)
      : vertex_(vertex), region_(region), rule_(rule), size_(rule.grid().box().longest_side()) {}

  // The rays of the boundary at the vertex, first the one from which the region lies
  // counter-clockwise.
  std::vector<Ray> rays() const {
    std::vector<Ray> found;
    for (int k = 0; k < region_.primitive_count(); ++k) {
      Point gradient{};
      const double value = region_.level(k).value_and_gradient(vertex_, gradient);
      const double slope = std::hypot(gradient[0], gradient[1]);
      if (!(std::fabs(value) < 1e-9 * size_ * slope)) continue;
      for (const double sign : {1.0, -1.0}) {
        const double angle = std::atan2(sign * gradient[0], -sign * gradient[1]);
        const bool before = is_inside(angle - 1e-3), after = is_inside(angle + 1e-3);
        if (before == after) continue;
        const Ray ray{angle, k};
        after ? (void)found.insert(found.begin(), ray) : found.push_back(ray);
      }
    }
    return found;
  }

  // How far the boundary is that does not lie on the rays.
  double clearance(const std::vector<Ray>& rays) const {
    const SurfacePoints& points = rule_.boundary().points;
    double nearest = size_;
    for (int i = 0; i < points.size(); ++i) {
      const Point at = points.point(i);
      const double x = at[0] - vertex_[0], y = at[1] - vertex_[1], r = std::hypot(x, y);
      const bool on_ray = std::ranges::any_of(rays, [&](const Ray& ray) {
        const double c = std::cos(ray.angle), s = std::sin(ray.angle);
        return c * x + s * y > 0 && std::fabs(c * y - s * x) < 1e-9 * size_;
      });
      if (!on_ray) nearest = std::min(nearest, r);
    }
    return nearest;
  }

  bool has_values(const Ray& ray, const std::vector<PieceCondition>& conditions) const {
    const Point at = on(ray.angle, 1e-6 * size_);
    for (const PieceCondition& condition : conditions) {
      if (condition.primitive != ray.primitive) continue;
      if (condition.where && Tape({*condition.where}, {0}, 2).value(at) < 0) continue;
      return condition.kind == Condition::Kind::value;
    }
    return false;
  }

 private:
  Point on(double angle, double distance) const {
    return {vertex_[0] + distance * std::cos(angle), vertex_[1] + distance * std::sin(angle)};
  }
  bool is_inside(double angle) const { return region_.contains(on(angle, 1e-5 * size_)); }

  Point vertex_;
  const RegionEvaluator& region_;
  const DomainRule& rule_;
  double size_;
};

// kπ/opening, or (k − ½)π/opening where the conditions of the two sides differ; whole numbers are
// polynomials.
std::vector<double> automatic_exponents(double opening, bool differ) {
  std::vector<double> exponents;
  for (int k = 1; exponents.size() < automatic_count && k < 20; ++k) {
    const double exponent = (differ ? k - 0.5 : k) * pi / opening;
    if (std::fabs(exponent - std::round(exponent)) > 1e-6) exponents.push_back(exponent);
  }
  return exponents;
}

}  // namespace

std::vector<SingularTerm> singular_terms(const Enrichment& enrichment,
                                         const std::vector<PieceCondition>& conditions,
                                         const RegionEvaluator& region, const DomainRule& rule) {
  const Surroundings around(enrichment.at, region, rule);
  const std::vector<Ray> rays = around.rays();
  if (rays.size() != 2)
    refuse("there are not two sides of the boundary at this point", enrichment.place);
  double opening = rays[1].angle - rays[0].angle;
  if (opening <= 1e-9) opening += 2 * pi;
  // exp(−(r/w)⁴) is rounding from 2.5 w on.
  const double width = around.clearance(rays) / 2.5;
  if (!(width > 1e-3 * rule.grid().box().longest_side()))
    refuse("the sides of the boundary at this point are not straight", enrichment.place);
  const bool first = around.has_values(rays[0], conditions),
             last = around.has_values(rays[1], conditions);
  const std::vector<double> exponents = enrichment.exponents.empty()
                                            ? automatic_exponents(opening, first != last)
                                            : enrichment.exponents;
  if (exponents.empty())
    refuse("nothing is singular here: all exponents are whole numbers", enrichment.place);
  const Corner corner{enrichment.at, rays[0].angle, opening};
  const Field square =
      pow(x_coordinate() - enrichment.at[0], 2) + pow(y_coordinate() - enrichment.at[1], 2);
  const Field near = exp(-pow(square / (width * width), 2));
  std::vector<SingularTerm> terms;
  for (const double exponent : exponents) {
    const Field s = first ? corner_sine(corner, exponent) : corner_cosine(corner, exponent);
    terms.push_back(
        {near * s, fmt::format("r^{0:.6g} {1}({0:.6g} theta)", exponent, first ? "sin" : "cos")});
  }
  return terms;
}

}  // namespace rfm
