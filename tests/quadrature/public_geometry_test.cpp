// The shapes of the public list of reference values, with default settings: measure, boundary,
// second moments by the formulas given there, and ∫ x⁴ y² by integrals of our own, in the plane
// over the boundary (Green's theorem on arcs and segments known in closed form), in space over
// profiles and slices.

#include <gmock/gmock.h>

#include <functional>

#include "core/primitives.hpp"
#include "quadrature/integrate.hpp"
#include "tests/quadrature/standard_regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

double integral(const DomainRule& rule, const std::function<double(const Point&)>& f) {
  return integrate(rule, [&](const QuadratureBlock& block, double* values) {
    for (int k = 0; k < block.count; ++k) {
      Point p{};
      for (int axis = 0; axis < rule.dimension(); ++axis) p[axis] = block.coordinates[axis][k];
      values[k] = f(p);
    }
  });
}
double x4y2(const Point& p) { return std::pow(p[0], 4) * p[1] * p[1]; }

DomainRule rule_for(const Region& region, double half, int dimension) {
  return make_domain_rule(RegionEvaluator(region), grid(half, dimension == 2 ? 64 : 24, dimension));
}

// ∫ f over [a, b], for functions analytic there.
double gauss(double a, double b, const std::function<double(double)>& f) {
  const GaussRule& rule = gauss_legendre(30);
  double sum = 0;
  for (int i = 0; i < rule.size(); ++i)
    sum += (b - a) * rule.weights[i] * f(a + (b - a) * rule.nodes[i]);
  return sum;
}

// ∫ x⁵y²/5 dy along a segment, and along an arc about c from angle a to b.
double along_segment(const Point& p, const Point& q) {
  return gauss(0, 1, [&](double t) {
    const double x = p[0] + t * (q[0] - p[0]), y = p[1] + t * (q[1] - p[1]);
    return std::pow(x, 5) * y * y / 5 * (q[1] - p[1]);
  });
}
double along_arc(const Point& c, double r, double a, double b) {
  return gauss(a, b, [&](double t) {
    const double x = c[0] + r * std::cos(t), y = c[1] + r * std::sin(t);
    return std::pow(x, 5) * y * y / 5 * r * std::cos(t);
  });
}
double over_polygon(const std::vector<Point>& corners) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i)
    sum += along_segment(corners[i], corners[(i + 1) % corners.size()]);
  return sum;
}

TEST(PublicGeometry, Rectangle) {
  const Region region = region_of((4 - square(x())) / 4, 2) & region_of((1 - square(y())) / 2, 2);
  const DomainRule rule = rule_for(region, 2.1, 2);
  EXPECT_NEAR(rule.measure(), 8, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 12, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[1] * p[1]; }), 8.0 / 3, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] * p[0]; }), 32.0 / 3, 1e-13);
  EXPECT_NEAR(integral(rule, x4y2), 64.0 / 5 * 2 / 3, 1e-13);
}

TEST(PublicGeometry, LShape) {
  const Region region = box({0, 0}, {2, 1}) | box({0, 0}, {1, 2});
  const DomainRule rule = rule_for(region, 2.1, 2);
  EXPECT_NEAR(rule.measure(), 3, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 8, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] / 3; }), 5.0 / 6, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[1] * p[1]; }), 3, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] * p[1]; }), 1.75, 1e-13);
  EXPECT_NEAR(integral(rule, x4y2), 32.0 / 5 / 3 + 1.0 / 5 * (8 - 1) / 3, 1e-13);
}

TEST(PublicGeometry, Pentagram) {
  // Lines at the distance r cos 36° of the inner corners.
  const double inner = (3 - std::sqrt(5.0)) / 2;
  const DomainRule rule = rule_for(star(inner * std::cos(pi / 5), 0.1 * pi), 1.1, 2);
  EXPECT_NEAR(rule.measure(), 1.1225699414489634, 1e-14);
  EXPECT_NEAR(rule.boundary_measure(), 7.2654252800536089, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] * p[0] + p[1] * p[1]; }),
              0.27220731298929889, 1e-14);
  std::vector<Point> corners;
  for (int k = 0; k < 10; ++k) {
    const double r = k % 2 ? inner : 1, t = pi / 2 + k * pi / 5;
    corners.push_back({r * std::cos(t), r * std::sin(t)});
  }
  EXPECT_NEAR(integral(rule, x4y2), over_polygon(corners), 1e-14);
}

TEST(PublicGeometry, VNotchDisk) {
  const DomainRule rule = rule_for(standard_regions_2d()[5].region, 3.1, 2);
  EXPECT_NEAR(rule.measure(), 19.205750411731104, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 24.13716694115407, 1e-13);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[1]; }) / rule.measure(),
              0.66271412407731212, 1e-14);
  // From the notch below along the arc to the right, and back through the notch above.
  const double s = 3 / std::sqrt(2.0);
  double exact = along_arc({0, 0}, 3, -pi / 4, 5 * pi / 4);
  const std::vector<Point> notch{{-s, -s}, {-1, -1}, {-1, 1}, {0, 0}, {1, 1}, {1, -1}, {s, -s}};
  for (std::size_t i = 0; i + 1 < notch.size(); ++i) exact += along_segment(notch[i], notch[i + 1]);
  EXPECT_NEAR(integral(rule, x4y2) / exact, 1, 1e-13);
}

TEST(PublicGeometry, DiskMinusDisks) {
  const Region region = disk(0, 0, 2) - disk(1, 0, 0.5) - disk(-0.8, 0.6, 0.4) - disk(0, -2, 0.7);
  const DomainRule rule = rule_for(region, 2.1, 2);
  EXPECT_NEAR(rule.measure(), 10.565970914074414, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 18.766838027594723, 1e-12);
  // Half the angles that the arcs of the bite and of the disk see across.
  const double a = std::acos(0.7 / 4), b = std::acos(1 - 0.49 / 8);
  const double exact = along_arc({0, 0}, 2, -pi / 2 + b, 1.5 * pi - b) +
                       along_arc({0, -2}, 0.7, pi / 2 + a, pi / 2 - a) -
                       along_arc({1, 0}, 0.5, 0, 2 * pi) - along_arc({-0.8, 0.6}, 0.4, 0, 2 * pi);
  EXPECT_NEAR(integral(rule, x4y2), exact, 1e-13);
}

TEST(PublicGeometry, SumOfSquareAndDisk) {
  // Four disks that touch the sides of two boxes.
  Region region = box({-1.5, -1}, {1.5, 1}) | box({-1, -1.5}, {1, 1.5});
  for (const double sx : {-1.0, 1.0})
    for (const double sy : {-1.0, 1.0}) region = region | disk(sx, sy, 0.5);
  const DomainRule rule = rule_for(region, 1.6, 2);
  EXPECT_NEAR(rule.measure(), 8.7853981633974483, 1e-13);
  EXPECT_NEAR(rule.boundary_measure(), 11.141592653589793, 1e-12);
  double exact = 0;
  for (int k = 0; k < 4; ++k) {
    const double t = k * pi / 2, c = std::round(std::cos(t)), s = std::round(std::sin(t));
    const auto turned = [&](double u, double v) { return Point{c * u - s * v, s * u + c * v}; };
    exact += along_segment(turned(1.5, -1), turned(1.5, 1)) +
             along_arc(turned(1, 1), 0.5, t, t + pi / 2);
  }
  EXPECT_NEAR(integral(rule, x4y2), exact, 1e-13);
}

// ∫ x⁴y² over what turns about z: the mean of cos⁴ sin² is 1/16.
double over_turned(double from, double to, const std::function<double(double)>& inner,
                   const std::function<double(double)>& outer) {
  return pi / 8 * gauss(from, to, [&](double z) {
           return (std::pow(outer(z), 8) - std::pow(inner(z), 8)) / 8;
         });
}

TEST(PublicGeometry, Torus) {
  const Field ring = sqrt(square(x()) + square(y()));
  const DomainRule rule = rule_for(solid(0.25 - square(ring - 2) - square(z())), 2.6, 3);
  EXPECT_NEAR(rule.measure(), 9.8696044010893586, 1e-7);
  EXPECT_NEAR(rule.boundary_measure(), 39.478417604357434, 1e-5);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] * p[0] + p[1] * p[1]; }),
              41.328968429561689, 1e-6);
  // z = sin t / 2
  const double exact = pi / 8 * gauss(-pi / 2, pi / 2, [](double t) {
                         const double c = std::cos(t) / 2;
                         return (std::pow(2 + c, 8) - std::pow(2 - c, 8)) / 8 * c;
                       });
  EXPECT_NEAR(integral(rule, x4y2) / exact, 1, 1e-7);
}

TEST(PublicGeometry, NapkinRing) {
  const Field ring = square(x()) + square(y());
  const DomainRule rule = rule_for(solid(4 - ring - square(z())) - solid(1 - ring), 2.1, 3);
  EXPECT_NEAR(rule.measure() / 21.765592370810614, 1, 1e-10);
  EXPECT_NEAR(rule.boundary_measure() / 65.296777112431843, 1, 1e-8);
  const double exact = over_turned(
      -std::sqrt(3.0), std::sqrt(3.0), [](double) { return 1; },
      [](double z) { return std::sqrt(4 - z * z); });
  EXPECT_NEAR(integral(rule, x4y2) / exact, 1, 1e-10);
}

TEST(PublicGeometry, CubeMinusBall) {
  const double r = 1.2, h = r - 1;
  const Region region =
      box({-1, -1, -1}, {1, 1, 1}, 3) - solid(r * r - square(x()) - square(y()) - square(z()));
  const DomainRule rule = rule_for(region, 1.1, 3);
  EXPECT_NEAR(rule.measure(), 1.6162837279055401, 1e-9);
  EXPECT_NEAR(rule.boundary_measure(), 24.75398223686155, 1e-7);
  // The ball without its caps; ∫ x⁴, y² and x⁴y² over disks of radius s are π s⁶/8, π s⁴/4, π
  // s⁸/64.
  const auto cap = [&](int power, const std::function<double(double, double)>& slice) {
    return 2 * gauss(1, r, [&](double t) {
             const double s2 = r * r - t * t;
             return pi * slice(t, std::pow(s2, power));
           });
  };
  EXPECT_NEAR(cap(1, [](double, double s2) { return s2; }), 2 * pi * h * h * (3 * r - h) / 3,
              1e-15);
  const double ball = 4 * pi / 9 * std::pow(r, 9) * 3 / 105;
  const double caps = cap(2, [](double t, double s4) { return std::pow(t, 4) * s4 / 4; }) +
                      cap(3, [](double t, double s6) { return t * t * s6 / 8; }) +
                      cap(4, [](double, double s8) { return s8 / 64; });
  EXPECT_NEAR(integral(rule, x4y2), 8.0 / 15 - (ball - caps), 1e-9);
}

TEST(PublicGeometry, Gyroid) {
  const auto wave = [](const Field& a, const Field& b) { return sin(a) * cos(b); };
  const Region region = solid(-(wave(x(), y()) + wave(y(), z()) + wave(z(), x())));
  Box cell = cube_box(1, 3);
  cell.low = {};
  cell.high = {2 * pi, 2 * pi, 2 * pi};
  const DomainRule rule = make_domain_rule(RegionEvaluator(region), Grid(cell, {16, 16, 16}));
  EXPECT_NEAR(rule.measure() / (4 * pi * pi * pi), 1, 1e-10);
}

TEST(PublicGeometry, SumOfBalls) {
  const DomainRule rule = rule_for(solid(4 - square(x() - 1) - square(y()) - square(z())), 3.1, 3);
  EXPECT_NEAR(rule.measure() / 33.510321638291128, 1, 1e-10);
  EXPECT_NEAR(rule.boundary_measure() / 50.265482457436692, 1, 1e-9);
  // (1 + u)⁴v² over the ball: ∫ v² + 6 u²v² + u⁴v².
  const double exact = 4 * pi * (32.0 / 15 + 6 * 128.0 / 7 / 15 + 512.0 / 9 * 3 / 105);
  EXPECT_NEAR(integral(rule, x4y2) / exact, 1, 1e-10);
}

TEST(PublicGeometry, ChessPawn) {
  const StandardRegion pawn = standard_regions_3d()[5];
  const DomainRule rule =
      make_domain_rule(RegionEvaluator(pawn.region), Grid(pawn.box, {24, 24, 24}));
  EXPECT_NEAR(rule.measure() / 63.014937055967049, 1, 1e-7);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[2]; }) / rule.measure(),
              2.0613486342376875, 1e-6);
  EXPECT_NEAR(integral(rule, [](const Point& p) { return p[0] * p[0] + p[1] * p[1]; }),
              160.57212882741486, 1e-4);
  // The radius at each height is the largest of three; between their crossings all is analytic.
  const auto neck = [](double z) {
    return std::clamp(4 - 4 * std::sqrt(std::max(z, 0.0) / 7), 0.0, 3.0);
  };
  const auto collar = [](double z) { return std::sqrt(std::max(2 - 9 * (6 - z) * (6 - z), 0.0)); };
  const auto head = [](double z) { return std::sqrt(std::max(1 - (7 - z) * (7 - z), 0.0)); };
  const auto radius = [&](double z) {
    return std::max({z <= 7 ? neck(z) : 0.0, collar(z), head(z)});
  };
  double exact = 0;
  const double end = std::sqrt(2.0) / 3;
  std::vector<double> breaks{0, 7.0 / 16, 6 - end, 6 + end, 6, 7, 8};
  const auto crossing = [&](double a, double b, auto&& f, auto&& g) {
    for (int step = 0; step < 100; ++step) {
      const double middle = 0.5 * (a + b);
      ((f(a) > g(a)) == (f(middle) > g(middle)) ? a : b) = middle;
    }
    return 0.5 * (a + b);
  };
  breaks.push_back(crossing(6 - end, 6, neck, collar));
  breaks.push_back(crossing(6, 6 + end, neck, collar));
  breaks.push_back(crossing(
      6, 7, [&](double z) { return std::max(neck(z), collar(z)); }, head));
  std::ranges::sort(breaks);
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
    // Square roots at the ends: z = a + (b − a) sin² t.
    const double a = breaks[i], b = breaks[i + 1];
    exact += pi / 8 * gauss(0, pi / 2, [&](double t) {
               const double z = a + (b - a) * std::pow(std::sin(t), 2);
               return std::pow(radius(z), 8) / 8 * (b - a) * std::sin(2 * t);
             });
  }
  EXPECT_NEAR(integral(rule, x4y2) / exact, 1, 1e-6);
}

}  // namespace
