#include "core/piece_loops.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.hpp"
#include "core/point_algebra.hpp"
#include "core/quadric.hpp"

namespace rfm {
namespace {

// The ends of a diameter, if the set is a full circle.
std::optional<std::array<Point, 2>> diameter_of(const ThinSet& set) {
  if (!set.points.empty() || !set.ends.empty() || !set.surface) return std::nullopt;
  const std::optional<Quadric> quadric = as_quadric(*set.surface, 2);
  if (!quadric) return std::nullopt;
  const double a = quadric->square[0];
  if (!(a != 0) || quadric->square[3] != a || quadric->square[1] != 0) return std::nullopt;
  const Point center{quadric->origin[0] - quadric->linear[0] / (2 * a),
                     quadric->origin[1] - quadric->linear[1] / (2 * a)};
  const double square = -quadric->value(center) / a;
  if (!(square > 0)) return std::nullopt;
  const double radius = std::sqrt(square);
  return std::array<Point, 2>{{{center[0] + radius, center[1]}, {center[0] - radius, center[1]}}};
}

double size_of(const std::vector<LoopPiece>& pieces) {
  Point low, high;
  low.fill(std::numeric_limits<double>::infinity());
  high.fill(-std::numeric_limits<double>::infinity());
  for (const LoopPiece& piece : pieces)
    for (const Point& point : {piece.from, piece.to})
      for (int axis = 0; axis < 2; ++axis) {
        low[axis] = std::min(low[axis], point[axis]);
        high[axis] = std::max(high[axis], point[axis]);
      }
  return std::hypot(high[0] - low[0], high[1] - low[1]);
}

}  // namespace

std::vector<std::vector<LoopPiece>> closed_loops(const std::vector<ThinSet>& pieces) {
  if (pieces.empty()) throw InvalidArgument("a boundary without pieces does not exist");
  std::vector<LoopPiece> rest;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    const ThinSet& set = pieces[i];
    if (set.dimension == 2 && set.points.size() == 2) {
      rest.push_back({i, set.points[0], set.points[1], set.bulge});
      continue;
    }
    const auto diameter = set.dimension == 2 ? diameter_of(set) : std::nullopt;
    if (!diameter)
      throw InvalidArgument("closed boundaries are made of segments and arcs, or of triangles");
    rest.push_back({i, (*diameter)[0], (*diameter)[1], 1});
    rest.push_back({i, (*diameter)[1], (*diameter)[0], 1});
  }
  const double tolerance = 1e-9 * size_of(rest);
  const auto same = [&](const Point& a, const Point& b) {
    return norm(difference(a, b)) <= tolerance;
  };
  std::vector<std::vector<LoopPiece>> loops;
  while (!rest.empty()) {
    std::vector<LoopPiece> loop{rest[0]};
    rest.erase(rest.begin());
    while (!same(loop.back().to, loop[0].from)) {
      const Point end = loop.back().to;
      auto next = std::ranges::find_if(
          rest, [&](const Point& from) { return same(from, end); }, &LoopPiece::from);
      if (next == rest.end()) {
        next = std::ranges::find_if(
            rest, [&](const Point& to) { return same(to, end); }, &LoopPiece::to);
        if (next == rest.end()) throw InvalidArgument("the pieces do not close");
        std::swap(next->from, next->to);
        next->bulge = -next->bulge;
      }
      loop.push_back(*next);
      rest.erase(next);
    }
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace rfm
