#pragma once

#include <fmt/format.h>

#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <vector>

#include "core/primitives.hpp"

/// Random Boolean combinations of shapes in the plane and in space, which can be written as the
/// `geometry` of a problem file and made smaller shape by shape.
namespace rfm::test {

/// One shape with the lines that describe it in a problem file, without its name.
struct RandomShape {
  Region region;
  std::string text;
};

/// A binary tree over shapes; a leaf has no operator.
struct RandomTree {
  char operation = 0;  // & | - ^
  int shape = 0;
  std::vector<RandomTree> branches;

  Region region(const std::vector<RandomShape>& shapes) const {
    if (operation == 0) return shapes[shape].region;
    const Region a = branches[0].region(shapes), b = branches[1].region(shapes);
    switch (operation) {
      case '&':
        return a & b;
      case '|':
        return a | b;
      case '-':
        return a - b;
      default:
        return a ^ b;
    }
  }
  std::string text() const {
    if (operation == 0) return fmt::format("s{}", shape);
    return fmt::format("({} {} {})", branches[0].text(), operation, branches[1].text());
  }
  void list_shapes(std::vector<int>& list) const {
    if (operation == 0) list.push_back(shape);
    for (const RandomTree& branch : branches) branch.list_shapes(list);
  }
};

struct RandomDomain {
  int dimension = 2;
  unsigned seed = 0;
  /// Places, sizes and angles are multiples of 1/4 and 45°: faces on grid lines, tangencies,
  /// coincident surfaces and corners at vertices of the grid are the rule.
  bool on_lattice = false;
  std::vector<RandomShape> shapes;
  RandomTree tree;

  Region region() const { return tree.region(shapes); }
  /// All of the domain lies in it.
  static constexpr double half_side = 1.5;
  /// As in a problem file.
  std::string text() const {
    std::vector<int> used;
    tree.list_shapes(used);
    std::string result = fmt::format("# seed {}\ngeometry:\n  shapes:\n", seed);
    for (const int shape : used) result += fmt::format("    s{}: {}\n", shape, shapes[shape].text);
    return result + "  domain: \"" + tree.text() + "\"\n";
  }
};

/// Makes shapes from a seeded generator, the same ones with every standard library.
class RandomDomainMaker {
 public:
  RandomDomainMaker(unsigned seed, int dimension) : generator_(seed * 2u + dimension % 2) {
    domain_.dimension = dimension;
    domain_.seed = seed;
    domain_.on_lattice = whole(4) == 0;
  }

  /// 2 to 8 shapes, the first of which bounds the domain.
  RandomDomain make() {
    const int count = 2 + whole(7);
    domain_.shapes.push_back(frame());
    for (int i = 1; i < count; ++i) domain_.shapes.push_back(shape());
    domain_.tree = {'&', 0, {{0, 0, {}}, tree(1, count)}};
    return std::move(domain_);
  }

 private:
  int whole(int end) { return static_cast<int>(generator_() % static_cast<unsigned>(end)); }
  double uniform(double low, double high) {
    const double t = low + (high - low) * 0x1p-32 * (generator_() & 0xffffffffu);
    return domain_.on_lattice ? std::max(0.25 * std::round(4 * t), low >= 0 ? 0.25 : low) : t;
  }
  double angle() {
    constexpr double quarter = std::numbers::pi / 4;
    return domain_.on_lattice ? quarter * whole(8) : quarter * uniform(0, 8);
  }
  Point point(double reach) {
    Point result{};
    for (int axis = 0; axis < domain_.dimension; ++axis) result[axis] = uniform(-reach, reach);
    return result;
  }
  // A unit vector; on the lattice along an axis or a diagonal of a plane.
  Point direction() {
    const double a = angle(), b = domain_.dimension == 2 ? 0 : angle();
    return {std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b)};
  }

  RandomShape frame() {
    if (whole(2)) return round(Point{}, uniform(1, 1.5));
    Point half{};
    for (int axis = 0; axis < domain_.dimension; ++axis)
      half[axis] = uniform(0.5, 1.5 / std::sqrt(domain_.dimension) - 1e-3);
    return domain_.on_lattice ? straight_box(Point{}, half) : turned_box(Point{}, half);
  }

  RandomShape shape() {
    const int kind = whole(domain_.dimension == 2 ? 6 : 8);
    switch (kind) {
      case 0:
        return half(point(0.9), direction());
      case 1:
        return round(point(0.9), uniform(0.2, 0.9));
      case 2:
        return round_in_axes(point(0.8),
                             {uniform(0.25, 0.9), uniform(0.25, 0.9), uniform(0.3, 0.9)});
      case 3: {
        const Point center = point(0.8);
        const Point sides{uniform(0.2, 0.8), uniform(0.2, 0.8), uniform(0.2, 0.8)};
        return whole(2) ? straight_box(center, sides) : turned_box(center, sides);
      }
      case 4:
        return wave();
      case 5:
        return domain_.dimension == 2 ? parabola() : rod();
      case 6:
        return funnel();
      default:
        return ring();
    }
  }

  RandomShape half(const Point& at, const Point& normal) {
    const char* name = domain_.dimension == 2 ? "half_plane" : "half_space";
    return {domain_.dimension == 2 ? half_plane(at, normal) : half_space(at, normal),
            fmt::format("{{{}: {{point: {}, normal: {}}}}}", name, list(at), list(normal))};
  }
  RandomShape round(const Point& center, double radius) {
    const char* name = domain_.dimension == 2 ? "circle" : "sphere";
    return {domain_.dimension == 2 ? circle(center, radius) : sphere(center, radius),
            fmt::format("{{{}: {{center: {}, radius: {:.17g}}}}}", name, list(center), radius)};
  }
  RandomShape round_in_axes(const Point& center, const Point& radii) {
    const double turn = angle();
    constexpr double degrees = 180 / std::numbers::pi;
    if (domain_.dimension == 2)
      return {ellipse(center, radii, turn),
              fmt::format("{{ellipse: {{center: {}, radii: {}, angle: {:.17g}}}}}", list(center),
                          list(radii), degrees * turn)};
    const Point axis = direction();
    return {ellipsoid(center, radii, axis, turn),
            fmt::format("{{ellipsoid: {{center: {}, radii: {}, rotate: {{axis: {}, angle: "
                        "{:.17g}}}}}}}",
                        list(center), list(radii), list(axis), degrees * turn)};
  }
  RandomShape straight_box(const Point& center, const Point& half) {
    Point min{}, max{};
    for (int axis = 0; axis < domain_.dimension; ++axis) {
      min[axis] = center[axis] - half[axis];
      max[axis] = center[axis] + half[axis];
    }
    return {box(min, max, domain_.dimension),
            fmt::format("{{box: {{min: {}, max: {}}}}}", list(min), list(max))};
  }
  // A box in turned axes, as its half-planes (half-spaces).
  RandomShape turned_box(const Point& center, const Point& half_sides) {
    const double a = angle(), b = domain_.dimension == 2 ? 0 : angle();
    const double c = std::cos(a), s = std::sin(a), d = std::cos(b), e = std::sin(b);
    const std::array<Point, 3> axes{Point{c * d, s * d, e}, Point{-s, c, 0},
                                    Point{-c * e, -s * e, d}};
    std::vector<Region> sides;
    std::string text;
    for (int i = 0; i < domain_.dimension; ++i)
      for (const double sign : {-1.0, 1.0}) {
        Point at = center, normal{};
        for (int axis = 0; axis < 3; ++axis) {
          at[axis] += sign * half_sides[i] * axes[i][axis];
          normal[axis] = -sign * axes[i][axis];
        }
        sides.push_back(half(at, normal).region);
        std::string inside;  // (x − at) · normal
        for (int axis = 0; axis < domain_.dimension; ++axis)
          inside += fmt::format("{}({:.17g})*({} - ({:.17g}))", axis ? " + " : "", normal[axis],
                                "xyz"[axis], at[axis]);
        text = text.empty() ? inside : "min(" + text + ", " + inside + ")";
      }
    Region all = sides[0];
    for (std::size_t i = 1; i < sides.size(); ++i) all = all & sides[i];
    return {all, "{expression: \"" + text + "\"}  # as a conjunction of its terms"};
  }
  RandomShape expression(const Field& f, const std::string& text) {
    return {level_set(f, domain_.dimension), "{expression: \"" + text + "\"}"};
  }
  RandomShape wave() {
    const double level = uniform(-0.6, 0.6), height = uniform(0.1, 0.3), pace = uniform(1, 4);
    const Field x = x_coordinate(), last = domain_.dimension == 2 ? y_coordinate() : z_coordinate();
    Field bumps = sin(pace * x);
    if (domain_.dimension == 3) bumps = bumps * cos(pace * y_coordinate());
    return expression(
        level + height * bumps - last,
        fmt::format("{:.17g} + {:.17g}*sin({:.17g}*x){} - {}", level, height, pace,
                    domain_.dimension == 3 ? fmt::format("*cos({:.17g}*y)", pace) : std::string(),
                    domain_.dimension == 3 ? "z" : "y"));
  }
  RandomShape parabola() {
    const double a = uniform(-0.7, 0.7), b = uniform(-0.7, 0.7), width = uniform(0.3, 1);
    const Field x = x_coordinate() - a, y = y_coordinate() - b;
    return expression(width * y - x * x,
                      fmt::format("{:.17g}*(y - ({:.17g})) - (x - ({:.17g}))^2", width, b, a));
  }
  RandomShape rod() {
    const Point center = point(0.6), axis = direction();
    const double radius = uniform(0.2, 0.6), length = uniform(0.5, 2);
    return {cylinder(center, axis, radius, length),
            fmt::format("{{cylinder: {{center: {}, axis: {}, radius: {:.17g}, length: {:.17g}}}}}",
                        list(center), list(axis), radius, length)};
  }
  RandomShape funnel() {
    const Point apex = point(0.8), axis = direction();
    const double opening = domain_.on_lattice ? std::numbers::pi / 4 : uniform(0.4, 1.1);
    return {cone(apex, axis, opening, 1.5),
            fmt::format("{{cone: {{apex: {}, axis: {}, angle: {:.17g}, length: 1.5}}}}", list(apex),
                        list(axis), 180 / std::numbers::pi * opening)};
  }
  RandomShape ring() {
    const Point center = point(0.5), axis = direction();
    const double radius = uniform(0.5, 0.9), tube = std::min(0.2 + 0.25 * whole(2), 0.8 * radius);
    return {torus(center, axis, radius, tube),
            fmt::format("{{torus: {{center: {}, axis: {}, radius: {:.17g}, tube: {:.17g}}}}}",
                        list(center), list(axis), radius, tube)};
  }

  // Of shapes begin ≤ i < end; unions are frequent, or most domains would be empty.
  RandomTree tree(int begin, int end) {
    if (end - begin == 1) return {0, begin, {}};
    const int middle = begin + 1 + whole(end - begin - 1);
    constexpr char operations[] = "||||&&--^^";
    const char operation = operations[whole(10)];
    RandomTree first = tree(begin, middle);
    return {operation, 0, {std::move(first), tree(middle, end)}};
  }

  std::string list(const Point& p) const {
    if (domain_.dimension == 2) return fmt::format("[{:.17g}, {:.17g}]", p[0], p[1]);
    return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", p[0], p[1], p[2]);
  }

  std::mt19937 generator_;
  RandomDomain domain_;
};

inline RandomDomain random_domain(unsigned seed, int dimension) {
  return RandomDomainMaker(seed, dimension).make();
}

/// The smallest domain found by leaving out branches of the tree for which `fails` still holds.
template <class Fails>
RandomDomain shrunk(RandomDomain domain, Fails&& fails) {
  const auto shrink_at = [&](auto&& self, RandomTree& node) -> bool {
    if (node.operation == 0) return false;
    for (int kept = 0; kept < 2; ++kept) {
      const RandomTree whole = node;
      node = RandomTree(whole.branches[kept]);
      if (fails(domain)) return true;
      node = whole;
    }
    return self(self, node.branches[0]) || self(self, node.branches[1]);
  };
  // The first shape bounds the domain and stays.
  while (domain.tree.operation != 0 && shrink_at(shrink_at, domain.tree.branches[1])) {
  }
  return domain;
}

}  // namespace rfm::test
