#include "quadrature/gauss_legendre.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include "core/error.hpp"

namespace rfm {
namespace {

struct StoredRule {
  std::array<double, max_gauss_points> nodes{};
  std::array<double, max_gauss_points> weights{};
  GaussRule view;
};

// Pₙ(z) by the three-term recurrence; `slope` receives P′ₙ(z), |z| < 1.
long double legendre(int n, long double z, long double& slope) {
  long double value = 1, previous = 0;
  for (int k = 0; k < n; ++k) {
    const long double next = ((2 * k + 1) * z * value - k * previous) / (k + 1);
    previous = value;
    value = next;
  }
  slope = n * (z * value - previous) / (z * z - 1);
  return value;
}

void compute(int n, StoredRule& rule) {
  for (int i = 0; i < (n + 1) / 2; ++i) {
    // Tricomi's asymptotic root, largest first.
    long double z = std::cos(std::numbers::pi_v<long double> * (i + 0.75L) / (n + 0.5L)), slope = 0;
    for (int step = 0; step < 20; ++step) {
      const long double correction = legendre(n, z, slope) / slope;
      z -= correction;
      if (std::fabs(correction) < 1e-18L) break;
    }
    if (2 * i + 1 == n) z = 0;
    legendre(n, z, slope);
    const long double weight = 1 / ((1 - z * z) * slope * slope);
    rule.nodes[i] = static_cast<double>((1 - z) / 2);
    rule.nodes[n - 1 - i] = static_cast<double>((1 + z) / 2);
    rule.weights[i] = rule.weights[n - 1 - i] = static_cast<double>(weight);
  }
  rule.view = {std::span(rule.nodes).first(n), std::span(rule.weights).first(n)};
}

struct StoredRules {
  std::array<StoredRule, max_gauss_points + 1> of;
  StoredRules() {
    for (int points = 1; points <= max_gauss_points; ++points) compute(points, of[points]);
  }
};

}  // namespace

const GaussRule& gauss_legendre(int points) {
  if (points < 1 || points > max_gauss_points)
    throw InvalidArgument("a Gauss rule has 1 to " + std::to_string(max_gauss_points) +
                          " points, not " + std::to_string(points));
  static const StoredRules rules;
  return rules.of[points].view;
}

}  // namespace rfm
