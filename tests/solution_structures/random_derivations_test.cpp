// Structures derived from conditions alone, for random conditions on random regions: every
// condition holds at regular points of its piece, and the printed text is the same function.

#include <gmock/gmock.h>

#include <cmath>
#include <random>
#include <set>

#include "core/boundary_piece.hpp"
#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/function_shaping.hpp"
#include "core/primitives.hpp"
#include "core/tape.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure_derivation.hpp"
#include "solution_structures/structure_text.hpp"
#include "solution_structures/verification.hpp"

namespace rfm {
namespace {

class Random {
 public:
  explicit Random(unsigned seed) : engine_(seed) {}
  double number(double low, double high) { return low + (high - low) * (engine_() / 0x1p32); }
  int whole(int count) { return static_cast<int>(engine_() % static_cast<unsigned>(count)); }
  Field field() {
    const Field phase = number(-2, 2) * x_coordinate() + number(-2, 2) * y_coordinate();
    return number(-1, 1) + sin(phase + number(-3, 3));
  }
  /// At least ½.
  Field positive() { return 1.5 + 0.5 * field(); }

 private:
  std::mt19937 engine_;
};

// A disk, of which disks and half-planes are taken away or to which disks are added.
Region random_region(Random& random) {
  Region region = circle({0, 0}, 1);
  for (int count = 1 + random.whole(5); count-- > 0;) {
    const double angle = random.number(0, 6.28), distance = random.number(0.3, 1.1);
    const Point at{distance * std::cos(angle), distance * std::sin(angle)};
    switch (random.whole(3)) {
      case 0:
        region = region - circle(at, random.number(0.15, 0.5));
        break;
      case 1:
        region = region & half_plane(at, {-at[0], -at[1]});
        break;
      default:
        region = region | circle(at, random.number(0.3, 0.7));
    }
  }
  return region;
}

struct Piece {
  Field omega;                // from inside
  Field distance;             // positive on both sides
  std::vector<Field> normal;  // outward, from the polynomial of the primitive
  std::vector<Point> points;
};

// Points of a rule with three points are on the surface to seven digits where it is hard to follow.
Point on_surface(Point point, const LevelFunction& level) {
  for (int step = 0; step < 3; ++step) {
    Point gradient;
    const double value = level.value_and_gradient(point, gradient);
    const double square = gradient[0] * gradient[0] + gradient[1] * gradient[1];
    for (int axis = 0; axis < 2; ++axis) point[axis] -= value * gradient[axis] / square;
  }
  return point;
}

std::vector<Piece> pieces_of(const Region& region) {
  const RegionEvaluator evaluator(region);
  const Box bounds = bounding_box(evaluator);
  QuadratureOptions options;
  options.inside_points = 1;
  options.cut_points = 3;
  options.compare_orders = false;
  const DomainRule rule = make_domain_rule(evaluator, Grid::with_square_cells(bounds, 12), options);
  const SurfacePoints& points = rule.boundary().points;
  std::vector<Piece> pieces;
  for (int k = 0; k < evaluator.primitive_count(); ++k) {
    if (rule.boundary_measure(k) < 0.1) continue;
    const BoundaryPiece piece = boundary_piece(k, evaluator, bounds);
    Piece own{level_off(piece.from_inside, 1), piece.function, outward_normal(k, evaluator), {}};
    for (int i = 0; i < points.size(); ++i)
      if (points.numbers[i] == k)
        own.points.push_back(on_surface(points.point(i), evaluator.level(k)));
    pieces.push_back(own);
  }
  // Regular points only: a distance away from all other pieces.
  for (Piece& own : pieces)
    for (const Piece& other : pieces) {
      if (&other == &own) continue;
      const Tape distance({other.distance}, {0}, 2);
      std::erase_if(own.points, [&](const Point& point) { return distance.value(point) < 0.1; });
    }
  std::erase_if(pieces, [](const Piece& piece) { return piece.points.empty(); });
  return pieces;
}

// What shall hold on a piece: operators with the piece's own normal, and data.
struct Requirement {
  BoundaryOperator condition;
  Field data;
};

Field across(const std::vector<Field>& n, const Field& u) {
  return n[0] * partial(u, 0) + n[1] * partial(u, 1);
}

std::pair<StructureCondition, std::vector<Requirement>> random_condition(const Piece& piece,
                                                                         Random& random) {
  const std::vector<Field> n = piece.normal;
  const Field data = random.field(), other = random.field(), a = random.field(),
              b = random.positive();
  const Requirement value{[](const auto& u) { return u[0]; }, data};
  switch (random.whole(6)) {
    case 0:
      return {{ValueCondition{data}, piece.omega}, {value}};
    case 1:
      return {{SlopeCondition{data}, piece.omega},
              {{[n](const auto& u) { return across(n, u[0]); }, data}}};
    case 2:
      return {{RobinData{a, b, data}, piece.omega},
              {{[n, a, b](const auto& u) { return a * u[0] + b * across(n, u[0]); }, data}}};
    case 3: {
      // Not tangential anywhere: at most 60° from the normal of the primitive.
      const double angle = random.number(-1, 1), c = std::cos(angle), s = std::sin(angle);
      const std::vector<Field> l{b * (c * n[0] - s * n[1]), b * (s * n[0] + c * n[1])};
      return {{ObliqueData{l, a, data}, piece.omega},
              {{[l, a](const auto& u) { return a * u[0] + across(l, u[0]); }, data}}};
    }
    case 4:
      return {{ClampedCondition{data, other}, piece.omega},
              {value, {[n](const auto& u) { return across(n, u[0]); }, other}}};
    default: {
      const auto moment = [n](const std::vector<Field>& u) {
        const Field bending = n[0] * n[0] * partial(u[0], {2, 0}) +
                              2 * n[0] * n[1] * partial(u[0], {1, 1}) +
                              n[1] * n[1] * partial(u[0], {0, 2});
        return -bending - 0.3 * (laplacian(u[0], 2) - bending);
      };
      return {{SupportData{data, other}, piece.omega}, {value, {moment, other}}};
    }
  }
}

// The text, read where the names have their meaning, is the same function.
void expect_read_back(const Structure& structure, const std::vector<Piece>& pieces) {
  StructureNames names;
  ExpressionScope scope = coordinate_scope(2);
  define_structures(scope, 2, structure.unknown_count());
  for (std::size_t k = 0; k < pieces.size(); ++k)
    names.emplace_back("omega(piece" + std::to_string(k) + ")", pieces[k].omega);
  scope.define_function("omega",
                        {.call =
                             [&](std::span<const ExpressionArgument> arguments) {
                               return pieces[std::stoul(arguments[0].text.substr(5))].omega;
                             },
                         .takes_names = true});
  const std::string text = to_text(structure, names);
  EXPECT_EQ(text.find('\n'), text.npos);
  const Structure again = to_structure(Expression(text), scope);
  const Tape tape({random_solution({structure}, 2, 5)[0], random_solution({again}, 2, 5)[0]},
                  {0, 0}, 2);
  for (const Piece& piece : pieces)
    for (const Point& point : piece.points) {
      const Point inside{0.9 * point[0], 0.9 * point[1]};
      const double expected = tape.value(inside, 0);
      if (!std::isfinite(expected)) continue;
      EXPECT_NEAR(tape.value(inside, 1), expected, 1e-13 * (1 + std::fabs(expected))) << text;
    }
}

void check(int first, int count) {
  int derived = 0, requirements = 0;
  std::set<std::size_t> sizes;
  double worst = 0;
  for (unsigned seed = static_cast<unsigned>(first); derived < count; ++seed) {
    Random random(seed);
    const Region region = random_region(random);
    std::vector<Piece> pieces;
    try {
      pieces = pieces_of(region);
    } catch (const InvalidArgument&) {
      continue;  // nothing is left of the region
    }
    if (pieces.size() < 2 || pieces.size() > 6) continue;
    std::vector<StructureCondition> conditions;
    std::vector<std::vector<Requirement>> required;
    for (const Piece& piece : pieces) {
      auto [condition, requirement] = random_condition(piece, random);
      conditions.push_back(condition);
      required.push_back(requirement);
    }
    const Structure u = derived_structure(conditions);
    for (std::size_t k = 0; k < pieces.size(); ++k)
      for (const Requirement& requirement : required[k]) {
        const StructureDeviation deviation = largest_deviation(
            {u}, requirement.condition, requirement.data, pieces[k].points, {.count = 1});
        EXPECT_LT(deviation.largest, 1e-9)
            << "seed " << seed << ", piece " << k << " of " << pieces.size() << ", condition "
            << conditions[k].condition.index() << " at " << deviation.place[0] << ", "
            << deviation.place[1];
        worst = std::max(worst, deviation.largest);
        ++requirements;
      }
    expect_read_back(u, pieces);
    sizes.insert(pieces.size());
    ++derived;
  }
  std::printf("%d structures, %d conditions, largest deviation %.1e\n", derived, requirements,
              worst);
  EXPECT_EQ(sizes.size(), 5u) << "regions of 2 to 6 pieces";
}

TEST(RandomDerivations, EveryConditionHoldsAndTheTextReadsBack) { check(1, 40); }
TEST(LongRandomDerivations, EveryConditionHoldsAndTheTextReadsBack) { check(1000, 400); }

}  // namespace
}  // namespace rfm
