#include "core/triangle_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

#include "core/box_tree.hpp"
#include "core/point_algebra.hpp"
#include "core/point_fields.hpp"

namespace rfm {
namespace {

// Normalised where it is zero.
Field end_around_line(const Point& on, const Point& direction, double distance, int dimension) {
  const Field height = height_along(direction, on, dimension);
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
        const Point offset = difference(nearest_point(feature.points, center).nearest, center);
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
    const Point ab = difference(triangle[1], triangle[0]),
                ac = difference(triangle[2], triangle[0]);
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
    const Point direction = unit(difference(corners_[ends[1]], from));
    const Point across = unit(cross(faces_[face].normal, direction));
    double side = 0;
    for (const int corner : faces_[face].corners)
      side += dot(across, difference(corners_[corner], from));
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
          height_along(faces_[plane].normal, corners_[faces_[plane].corners[0]], dimension_);
      const auto& [a, b, c] = faces_[f].corners;
      Feature feature{{corners_[a], corners_[b], corners_[c]}, {}};
      for (int i = 0; i < 3; ++i) {
        const Point &from = feature.points[i], &to = feature.points[(i + 1) % 3];
        feature.feet.push_back({unit(cross(faces_[f].normal, difference(to, from))), from});
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
      Feature feature{{from, to, to},
                      {{unit(difference(to, from)), from}, {unit(difference(from, to)), to}}};
      for (const int face : edges_.at(sharp[e]).faces) {
        const Point in = inward(sharp[e], face);
        feature.feet.push_back({{-in[0], -in[1], -in[2]}, from});
      }
      const Point& on = corners_[sharp[line][0]];
      const Point direction = unit(difference(corners_[sharp[line][1]], on));
      add_feature(line, 0, known, end_around_line(on, direction, distance_, dimension_),
                  std::move(feature));
    }
  }

  // Edges that go on straight at a corner.
  template <class Visit>
  void for_each_opposite_pair(int corner, const Visit& visit) const {
    const auto& others = neighbours_[corner];
    for (std::size_t i = 0; i < others.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Point first = unit(difference(corners_[others[i].corner], corners_[corner]));
        const Point second = unit(difference(corners_[others[j].corner], corners_[corner]));
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
      feature.feet.push_back({unit(difference(at, corners_[neighbour.corner])), at});
    functions.push_back(end_around(at, distance_, dimension_));
    features_.push_back({std::move(feature)});
  }

  double distance_from(const Point& point) const {
    double best = std::numeric_limits<double>::infinity();
    tree_->walk(
        point,
        [&](int i) {
          const Point offset = difference(nearest_point(triangles_[i], point).nearest, point);
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

}  // namespace

Field end_around(const Point& corner, double distance, int dimension) {
  return (distance * distance - square_distance(corner, dimension)) * (0.5 / distance);
}

PartEnds ends_around(const std::vector<Triangle>& triangles, double distance, int dimension) {
  auto features = std::make_shared<Features>(triangles, distance, dimension);
  PartEnds ends{std::move(features->functions), nullptr};
  ends.locator = std::move(features);
  return ends;
}

}  // namespace rfm
