#include "problems/pictures/region_pixels.hpp"

#include <tbb/blocked_range2d.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

namespace rfm {
namespace {

constexpr int large_tile = 64, small_tile = 8;
constexpr double infinity = std::numeric_limits<double>::infinity();

bool has_union(const BooleanExpression& expression) {
  return std::ranges::any_of(expression.negations_at_leaves().nodes(), [](const auto& node) {
    return node.kind == BooleanExpression::Kind::disjunction;
  });
}

struct Tile {
  int left, top, right, bottom;  // pixels, right and bottom excluded
};

class RegionSampler {
  using Kind = BooleanExpression::Kind;

 public:
  RegionSampler(const RegionEvaluator& region, const PixelWindow& window, double reach,
                RegionPixels& pixels)
      : region_(region),
        expression_(region.region().expression()),
        window_(window),
        reach_(reach),
        pixels_(pixels),
        signs_(static_cast<std::size_t>(region.primitive_count()), Truth::unknown),
        nodes_(expression_.nodes().size()),
        distances_(signs_.size()),
        has_union_(has_union(expression_)) {}

  void sample(const Tile& tile) {
    std::vector<int> all(signs_.size());
    for (std::size_t k = 0; k < all.size(); ++k) all[k] = static_cast<int>(k);
    std::ranges::fill(signs_, Truth::unknown);
    descend(tile, all);
  }

 private:
  // A signed distance and the primitive it comes from.
  struct Distance {
    double value = 0;
    int primitive = -1;
    double normal_x = 0, normal_y = 0;  // towards positive values
  };

  // `candidates` are the primitives whose sign is not known on the tile.
  void descend(const Tile& tile, const std::vector<int>& candidates) {
    const Box box = surroundings(tile);
    for (const int k : candidates) {
      const Interval range = region_.level(k).value_bounds(box);
      signs_[k] = range.low > 0 ? Truth::yes : range.high < 0 ? Truth::no : Truth::unknown;
    }
    const Truth inside = expression_.evaluate(signs_);
    if (inside != Truth::unknown) {
      fill(tile, inside == Truth::yes);
    } else {
      const auto relevant = std::make_unique<bool[]>(signs_.size());
      expression_.mark_relevant(signs_, std::span(relevant.get(), signs_.size()));
      std::vector<int> remaining;
      for (const int k : candidates)
        if (signs_[k] == Truth::unknown && relevant[k]) remaining.push_back(k);
      const int size = std::max(tile.right - tile.left, tile.bottom - tile.top);
      if (size <= small_tile)
        sample_pixels(tile, remaining);
      else
        for (const Tile& part : quarters(tile)) descend(part, remaining);
    }
    for (const int k : candidates) signs_[k] = Truth::unknown;
  }

  // All points that pixels of the tile ask about.
  Box surroundings(const Tile& tile) const {
    const double margin = (1.3 * reach_ + 1) * window_.pixel_size;
    Box box;
    box.dimension = 2;
    box.low = window_.centre(tile.left, tile.bottom - 1);
    box.high = window_.centre(tile.right - 1, tile.top);
    for (int axis = 0; axis < 2; ++axis) {
      box.low[axis] -= margin;
      box.high[axis] += margin;
    }
    return box;
  }

  static std::vector<Tile> quarters(const Tile& tile) {
    const int x = (tile.left + tile.right) / 2, y = (tile.top + tile.bottom) / 2;
    std::vector<Tile> parts;
    for (const Tile& part :
         {Tile{tile.left, tile.top, x, y}, Tile{x, tile.top, tile.right, y},
          Tile{tile.left, y, x, tile.bottom}, Tile{x, y, tile.right, tile.bottom}})
      if (part.left < part.right && part.top < part.bottom) parts.push_back(part);
    return parts;
  }

  void fill(const Tile& tile, bool inside) {
    for (int y = tile.top; y < tile.bottom; ++y)
      for (int x = tile.left; x < tile.right; ++x) store(x, y, inside ? infinity : -infinity, -1);
  }

  void sample_pixels(const Tile& tile, const std::vector<int>& primitives) {
    simplify();
    for (int y = tile.top; y < tile.bottom; ++y)
      for (int x = tile.left; x < tile.right; ++x) {
        const Point point = window_.centre(x, y);
        for (const int k : primitives) distances_[k] = distance_of(k, point);
        const Distance distance = combined();
        const bool is_near = std::abs(distance.value) <= reach_;
        if (!is_near || is_seam(point, distance, primitives))
          store(x, y, distance.value >= 0 || is_near ? infinity : -infinity, -1);
        else
          store(x, y, distance.value, distance.primitive);
      }
  }

  Distance distance_of(int k, const Point& point) const {
    Point gradient{};
    const double value = region_.level(k).value_and_gradient(point, gradient);
    if (std::isnan(value)) return {-infinity, k};
    const double length = std::hypot(gradient[0], gradient[1]);
    if (!(length > 0) || !std::isfinite(length)) return {value >= 0 ? infinity : -infinity, k};
    return {value / length / window_.pixel_size, k, gradient[0] / length, gradient[1] / length};
  }

  // What is left of the expression on a tile: nodes whose value is known get a distance that is
  // infinite, and `undecided_` lists those that are to be computed at each pixel.
  void simplify() {
    const auto& nodes = expression_.nodes();
    for (std::size_t i = 0; i < nodes.size(); ++i) nodes_[i] = value_of(nodes[i], true);
    std::vector<char> reached(nodes.size(), 0);
    reached.back() = 1;
    undecided_.clear();
    for (std::size_t i = nodes.size(); i-- > 0;) {
      if (!reached[i] || !std::isnan(nodes_[i].value)) continue;
      undecided_.push_back(static_cast<int>(i));
      if (nodes[i].kind == Kind::variable) continue;
      reached[nodes[i].first] = 1;
      if (nodes[i].kind != Kind::negation) reached[nodes[i].second] = 1;
    }
    std::ranges::reverse(undecided_);
  }

  Distance combined() {
    for (const int i : undecided_) nodes_[i] = value_of(expression_.nodes()[i], false);
    return nodes_.back();
  }

  // The distance of a node from those of its arguments; NaN stands for an unknown one.
  Distance value_of(const BooleanExpression::Node& node, bool is_unknown) const {
    switch (node.kind) {
      case Kind::constant:
        return {node.first ? infinity : -infinity};
      case Kind::variable: {
        const Truth sign = signs_[node.first];
        if (sign != Truth::unknown) return {sign == Truth::yes ? infinity : -infinity};
        return is_unknown ? Distance{std::numeric_limits<double>::quiet_NaN()}
                          : distances_[node.first];
      }
      case Kind::negation: {
        const Distance& a = nodes_[node.first];
        return {-a.value, a.primitive, -a.normal_x, -a.normal_y};
      }
      default: {
        const Distance &a = nodes_[node.first], &b = nodes_[node.second];
        const double decisive = node.kind == Kind::conjunction ? -infinity : infinity;
        if (a.value == decisive || b.value == decisive) return {decisive};
        if (std::isnan(a.value)) return a;
        if (std::isnan(b.value)) return b;
        return (a.value < b.value) == (node.kind == Kind::conjunction) ? a : b;
      }
    }
  }

  // Whether the other side of the supposed boundary is inside as well, as where parts of a union
  // touch. The probe lies beyond the boundary by more than the distance may be wrong.
  bool is_seam(const Point& point, const Distance& distance, const std::vector<int>& primitives) {
    if (!has_union_ || distance.value < -0.01) return false;  // outside is not within a union
    const double step = -(0.5 + 1.25 * distance.value) * window_.pixel_size;
    const Point beyond{point[0] + step * distance.normal_x, point[1] + step * distance.normal_y, 0};
    for (const int k : primitives)
      signs_[k] = region_.level(k).value(beyond) >= 0 ? Truth::yes : Truth::no;
    const bool is_inside = expression_.evaluate(signs_) != Truth::no;
    for (const int k : primitives) signs_[k] = Truth::unknown;
    return is_inside;
  }

  void store(int x, int y, double distance, int primitive) {
    const std::size_t pixel = static_cast<std::size_t>(y) * window_.width + x;
    pixels_.distance[pixel] = static_cast<float>(distance);
    pixels_.primitive[pixel] = primitive;
  }

  const RegionEvaluator& region_;
  const BooleanExpression& expression_;
  const PixelWindow& window_;
  double reach_;
  RegionPixels& pixels_;
  std::vector<Truth> signs_;
  std::vector<Distance> nodes_, distances_;
  std::vector<int> undecided_;
  bool has_union_;
};

}  // namespace

RegionPixels sample_region(const RegionEvaluator& region, const PixelWindow& window, double reach) {
  RegionPixels pixels;
  pixels.distance.resize(static_cast<std::size_t>(window.pixel_count()));
  pixels.primitive.resize(pixels.distance.size());
  const auto tiles = [](int size) { return (size + large_tile - 1) / large_tile; };
  tbb::parallel_for(tbb::blocked_range2d<int>(0, tiles(window.height), 0, tiles(window.width)),
                    [&](const auto& range) {
                      RegionSampler sampler(region, window, reach, pixels);
                      for (int row = range.rows().begin(); row < range.rows().end(); ++row)
                        for (int column = range.cols().begin(); column < range.cols().end();
                             ++column)
                          sampler.sample({column * large_tile, row * large_tile,
                                          std::min((column + 1) * large_tile, window.width),
                                          std::min((row + 1) * large_tile, window.height)});
                    });
  return pixels;
}

}  // namespace rfm
