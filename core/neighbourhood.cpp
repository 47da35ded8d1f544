#include "core/neighbourhood.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/error.hpp"
#include "core/quadric.hpp"
#include "core/segment_distance.hpp"

namespace rfm {
namespace {

Point minus(const Point& a, const Point& b) { return {a[0] - b[0], a[1] - b[1], a[2] - b[2]}; }
double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }
Point cross(const Point& a, const Point& b) {
  return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
Point unit(const Point& a) {
  const double size = std::sqrt(dot(a, a));
  return {a[0] / size, a[1] / size, a[2] / size};
}

Field square_distance(const Point& point, int dimension) {
  Field square = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    square = square + pow(coordinate(axis) - point[axis], 2.0);
  return square;
}
Field along(const Point& direction, const Point& from, int dimension) {
  Field result = 0.0;
  for (int axis = 0; axis < dimension; ++axis)
    result = result + direction[axis] * (coordinate(axis) - from[axis]);
  return result;
}

// Normalised where they are zero.
Field end_around(const Point& corner, double distance, int dimension) {
  return (distance * distance - square_distance(corner, dimension)) * (0.5 / distance);
}
Field end_around(const Point& on, const Point& direction, double distance, int dimension) {
  const Field height = along(direction, on, dimension);
  return (distance * distance - square_distance(on, dimension) + height * height) *
         (0.5 / distance);
}

// The points x with normal·(x − at) ≥ 0.
struct HalfSpace {
  Point normal, at;
  bool meets(const Box& box, double slack) const {
    double most = slack;
    for (int axis = 0; axis < box.dimension; ++axis)
      most += normal[axis] * ((normal[axis] > 0 ? box.high : box.low)[axis] - at[axis]);
    return most >= 0;
  }
};

// A corner, edge or face of a surface of triangles, with the half-spaces that hold the points whose
// foot may be on it.
struct Feature {
  Triangle points;  // repeated where it has fewer
  std::vector<HalfSpace> feet;
};

// Things that turn out to be parts of one.
class Groups {
 public:
  explicit Groups(std::size_t count) : above_(count) {
    for (std::size_t i = 0; i < count; ++i) above_[i] = static_cast<int>(i);
  }
  int of(int i) {
    while (above_[i] != i) i = above_[i] = above_[above_[i]];
    return i;
  }
  void join(int i, int j) { above_[of(i)] = of(j); }

 private:
  std::vector<int> above_;
};

// The ends around triangles whose corners may coincide: around segments and points, too. Faces
// side by side in a plane, and edges one after the other on a line, share their functions.
class Features : public EndLocator {
 public:
  Features(const std::vector<Triangle>& triangles, double distance, int dimension)
      : distance_(distance), dimension_(dimension), triangles_(triangles) {
    std::vector<Box> boxes;
    for (const Triangle& triangle : triangles) {
      add(triangle);
      Box& box = boxes.emplace_back(3, triangle[0], triangle[0]);
      for (const Point& corner : triangle)
        for (int axis = 0; axis < 3; ++axis) {
          box.low[axis] = std::min(box.low[axis], corner[axis]);
          box.high[axis] = std::max(box.high[axis], corner[axis]);
          size_ = std::max(size_, std::fabs(corner[axis]));
        }
    }
    tree_.emplace(boxes);
    add_faces();
    add_edges();
    for (std::size_t i = 0; i < corners_.size(); ++i) add_corner(static_cast<int>(i));
  }

  std::vector<Field> functions;

  void narrow(const Box& box, std::vector<int>& ends) const override {
    const Point center = box.center();
    double square = 0;
    for (int axis = 0; axis < box.dimension; ++axis)
      square += 0.25 * box.length(axis) * box.length(axis);
    const double slack = 1e-12 * (size_ + distance_ + std::sqrt(dot(center, center)));
    const double radius = std::sqrt(square) + slack;
    const double nearest = distance_from(center);
    // Distances change by at most as much as the point moves.
    if (std::fabs(nearest - distance_) > radius) return ends.clear();
    std::erase_if(ends, [&](int number) {
      return std::ranges::none_of(features_[number], [&](const Feature& feature) {
        for (const HalfSpace& half : feature.feet)
          if (!half.meets(box, slack)) return false;
        const Point offset = minus(nearest_point(feature.points, center).nearest, center);
        const double own = std::sqrt(dot(offset, offset));
        return own <= nearest + 2 * radius && std::fabs(own - distance_) <= radius;
      });
    });
  }

 private:
  struct Face {
    std::array<int, 3> corners;
    Point normal;
  };
  struct Edge {
    std::vector<int> faces;
    bool is_flat = false;
  };
  using Ends = std::array<int, 2>;
  static constexpr double rounding = 1e-12;

  int corner(const Point& point) {
    const auto [place, is_new] = numbers_.try_emplace(point, static_cast<int>(corners_.size()));
    if (is_new) corners_.push_back(point);
    return place->second;
  }

  void add(const Triangle& triangle) {
    std::array<int, 3> c{};
    for (int i = 0; i < 3; ++i) c[i] = corner(triangle[i]);
    const Point ab = minus(triangle[1], triangle[0]), ac = minus(triangle[2], triangle[0]);
    const Point normal = cross(ab, ac);
    const bool is_face = dot(normal, normal) > 1e-24 * dot(ab, ab) * dot(ac, ac);
    for (int i = 0; i < 3; ++i) {
      const int a = c[i], b = c[(i + 1) % 3];
      if (a == b) continue;
      Edge& edge = edges_[{std::min(a, b), std::max(a, b)}];
      if (is_face) edge.faces.push_back(static_cast<int>(faces_.size()));
    }
    if (is_face) faces_.push_back({c, unit(normal)});
  }

  // The direction across an edge into one of its faces.
  Point inward(const Ends& ends, int face) const {
    const Point& from = corners_[ends[0]];
    const Point direction = unit(minus(corners_[ends[1]], from));
    const Point across = unit(cross(faces_[face].normal, direction));
    double side = 0;
    for (const int corner : faces_[face].corners)
      side += dot(across, minus(corners_[corner], from));
    return side > 0 ? across : Point{-across[0], -across[1], -across[2]};
  }

  // The functions of a group get the features of all its members.
  void add_feature(int group, int side, std::map<std::array<int, 2>, int>& known,
                   const Field& function, Feature feature) {
    const auto [place, is_new] =
        known.try_emplace({group, side}, static_cast<int>(functions.size()));
    if (is_new) {
      functions.push_back(function);
      features_.emplace_back();
    }
    features_[place->second].push_back(std::move(feature));
  }

  // Both planes at the distance.
  void add_faces() {
    Groups planes(faces_.size());
    for (auto& [ends, edge] : edges_) {
      if (edge.faces.size() != 2) continue;
      const Point first = inward(ends, edge.faces[0]), second = inward(ends, edge.faces[1]);
      edge.is_flat = dot(first, second) < -1 + rounding;
      if (edge.is_flat) planes.join(edge.faces[0], edge.faces[1]);
    }
    std::map<std::array<int, 2>, int> known;
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const int plane = planes.of(static_cast<int>(f));
      const Field height =
          along(faces_[plane].normal, corners_[faces_[plane].corners[0]], dimension_);
      const auto& [a, b, c] = faces_[f].corners;
      Feature feature{{corners_[a], corners_[b], corners_[c]}, {}};
      for (int i = 0; i < 3; ++i) {
        const Point &from = feature.points[i], &to = feature.points[(i + 1) % 3];
        feature.feet.push_back({unit(cross(faces_[f].normal, minus(to, from))), from});
      }
      for (const int side : {1, -1}) {
        const Point& n = faces_[plane].normal;
        Feature half = feature;
        half.feet.push_back({{side * n[0], side * n[1], side * n[2]}, corners_[a]});
        add_feature(plane, side, known, distance_ - side * height, std::move(half));
      }
    }
  }

  // Those within a plane have no ends of their own: every foot on them is one on a face, too.
  void add_edges() {
    std::vector<Ends> sharp;
    neighbours_.resize(corners_.size());
    for (const auto& [ends, edge] : edges_) {
      if (edge.is_flat) continue;
      for (int i = 0; i < 2; ++i)
        neighbours_[ends[i]].push_back({ends[1 - i], static_cast<int>(sharp.size())});
      sharp.push_back(ends);
    }
    Groups lines(sharp.size());
    for (std::size_t c = 0; c < corners_.size(); ++c)
      for_each_opposite_pair(static_cast<int>(c), [&](int i, int j) { lines.join(i, j); });
    std::map<std::array<int, 2>, int> known;
    for (std::size_t e = 0; e < sharp.size(); ++e) {
      const int line = lines.of(static_cast<int>(e));
      const Point &from = corners_[sharp[e][0]], &to = corners_[sharp[e][1]];
      Feature feature{{from, to, to}, {{unit(minus(to, from)), from}, {unit(minus(from, to)), to}}};
      for (const int face : edges_.at(sharp[e]).faces) {
        const Point in = inward(sharp[e], face);
        feature.feet.push_back({{-in[0], -in[1], -in[2]}, from});
      }
      const Point& on = corners_[sharp[line][0]];
      const Point direction = unit(minus(corners_[sharp[line][1]], on));
      add_feature(line, 0, known, end_around(on, direction, distance_, dimension_),
                  std::move(feature));
    }
  }

  // Edges that go on straight at a corner.
  template <class Visit>
  void for_each_opposite_pair(int corner, const Visit& visit) const {
    const auto& others = neighbours_[corner];
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Point first = unit(minus(corners_[others[i].corner], corners_[corner]));
        const Point second = unit(minus(corners_[others[j].corner], corners_[corner]));
        if (dot(first, second) < -1 + rounding) visit(others[i].edge, others[j].edge);
      }
  }

  // Where an edge goes on straight, and within a plane, only a line or less has its foot there.
  void add_corner(int number) {
    const bool is_alone = edges_.empty();
    bool is_within = neighbours_[number].empty() && !is_alone;
    for_each_opposite_pair(number, [&](int, int) { is_within = true; });
    if (is_within) return;
    const Point& at = corners_[number];
    Feature feature{{at, at, at}, {}};
    for (const Neighbour& neighbour : neighbours_[number])
      feature.feet.push_back({unit(minus(at, corners_[neighbour.corner])), at});
    functions.push_back(end_around(at, distance_, dimension_));
    features_.push_back({std::move(feature)});
  }

  double distance_from(const Point& point) const {
    double best = std::numeric_limits<double>::infinity();
    tree_->walk(
        point,
        [&](int i) {
          const Point offset = minus(nearest_point(triangles_[i], point).nearest, point);
          best = std::min(best, dot(offset, offset));
        },
        [&] { return best; });
    return std::sqrt(best);
  }

  struct Neighbour {
    int corner, edge;
  };

  double distance_, size_ = 0;
  int dimension_;
  std::vector<Triangle> triangles_;
  std::optional<BoxTree> tree_;
  std::map<Point, int> numbers_;
  std::vector<Point> corners_;
  std::vector<Face> faces_;
  std::map<Ends, Edge> edges_;
  std::vector<std::vector<Neighbour>> neighbours_;  // of corners, along edges that are not flat
  std::vector<std::vector<Feature>> features_;      // by function
};

void require_positive(double distance) {
  if (!(distance > 0))
    throw InvalidArgument("a distance must be positive, got " + std::to_string(distance));
}

PartEnds ends_of(const std::vector<Triangle>& triangles, double distance, int dimension) {
  auto features = std::make_shared<Features>(triangles, distance, dimension);
  PartEnds ends{std::move(features->functions), nullptr};
  ends.locator = std::move(features);
  return ends;
}

// Of an arc or a circle about `center`: across it, and around its ends.
Neighbourhood around_arc(const ThinSet& arc, const Point& center, double radius, double distance) {
  const Field from_circle = sqrt(square_distance(center, arc.dimension)) - radius;
  Neighbourhood result{distance * distance - from_circle * from_circle, {}};
  result.ends.functions.push_back(end_around(center, radius + distance, arc.dimension));
  if (radius > distance)
    result.ends.functions.push_back(end_around(center, radius - distance, arc.dimension));
  if (arc.points.empty()) return result;
  Field from_ends = 0.0;
  std::array<Field, 2> sides;  // of the lines through the ends, ≥ 0 towards the arc
  for (int i = 0; i < 2; ++i) {
    const Point& end = arc.points[i];
    const Field square = square_distance(end, 2);
    from_ends = i == 0 ? square : min(from_ends, square);
    const double turn = i == 0 ? 1 : -1;
    sides[i] = along({-turn * (end[1] - center[1]), turn * (end[0] - center[0])}, center, 2);
    result.ends.functions.push_back(end_around(end, distance, 2));
  }
  const Field beside =
      arc.bulge <= 1 ? min(sides[0], sides[1]) : max(sides[0], sides[1]);  // 1: half a turn
  result.where = select(step(beside), result.where, distance * distance - from_ends);
  return result;
}

// Of all of a line or a circle, a plane or a sphere.
Neighbourhood around_surface(const ThinSet& set, double distance) {
  if (!set.where.is_constant() && set.points.empty())
    throw InvalidArgument("the distance from a part of a curve that a formula gives is not known");
  const std::optional<Quadric> q = as_quadric(*set.surface, set.dimension);
  if (q && q->is_affine()) {
    const double slope = std::sqrt(dot(q->linear, q->linear));
    const Field height = *set.surface / slope;
    return {distance * distance - height * height, {{distance - height, distance + height}}};
  }
  if (q) {
    const double curvature = q->square[0];
    bool is_round = q->linear == Point{} && -q->constant / curvature > 0;
    for (int i = 0; i < set.dimension; ++i)
      for (int j = 0; j < set.dimension; ++j)
        is_round = is_round && std::fabs(q->square[Quadric::square_index(i, j)] -
                                         (i == j ? curvature : 0)) <= 1e-14 * std::fabs(curvature);
    if (is_round) return around_arc(set, q->origin, std::sqrt(-q->constant / curvature), distance);
  }
  throw InvalidArgument(
      "the distance from a curve that a formula gives is known for lines and "
      "circles only");
}

}  // namespace

Neighbourhood neighbourhood(const std::vector<Triangle>& triangles, double distance) {
  require_positive(distance);
  const Field square = field(std::make_shared<const MeshSquareDistance>(triangles));
  return {distance * distance - square, ends_of(triangles, distance, 3)};
}

Neighbourhood neighbourhood(const ThinSet& set, double distance) {
  require_positive(distance);
  const int dimension = set.dimension;
  const auto is_curved = [](const ThinSet& part) {
    return part.surface && (part.points.empty() || part.bulge != 0);
  };
  if (set.parts.empty() && is_curved(set)) return around_surface(set, distance);
  const std::vector<ThinSet> parts = set.parts.empty() ? std::vector{set} : set.parts;
  std::vector<Triangle> triangles;
  for (const ThinSet& part : parts) {
    if (is_curved(part))
      throw InvalidArgument("the distance from several sets is known for straight ones only");
    const std::vector<Point>& p = part.points;
    triangles.push_back({p[0], p[p.size() > 1 ? 1 : 0], p.back()});
  }
  if (parts[0].points.size() == 3) return neighbourhood(triangles, distance);
  Neighbourhood result{0.0, ends_of(triangles, distance, dimension)};
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const std::vector<Point>& p = parts[i].points;
    const Field square =
        p.size() == 1 ? square_distance(p[0], dimension)
                      : field(std::make_shared<const SegmentDistance>(p[0], p[1], dimension));
    const Field within = distance * distance - square;
    result.where = i == 0 ? within : max(result.where, within);
  }
  return result;
}

}  // namespace rfm
