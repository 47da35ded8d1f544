#include "quadrature/height_direction.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

// A graph is preferred to a surface independent of the axis only when nearly as good.
constexpr double independent_score = 0.999;

double middle_magnitude(const Interval& interval) {
  const double middle = std::fabs(interval.middle());
  return std::isfinite(middle) ? middle : 0.0;
}

}  // namespace

HeightDirections find_heights(const Box& box, std::span<const FunctionBounds> surfaces,
                              double flatness) {
  HeightDirections choice;
  double nearest = 0;
  std::array<double, 3> scores{};
  for (int axis = 0; axis < box.dimension; ++axis) {
    bool serves = true;
    double score = 1, guess = 1;
    for (const FunctionBounds& surface : surfaces) {
      const Interval& along = surface.gradient[axis];
      serves &= surface.smooth;
      if (along.is_zero()) {
        score = std::min(score, independent_score);
        continue;
      }
      double total = 1e-300, across = 0;
      for (int other = 0; other < box.dimension; ++other) {
        total += middle_magnitude(surface.gradient[other]) * box.length(other);
        if (other != axis) across = std::max(across, surface.gradient[other].magnitude());
      }
      serves &= along.excludes_zero() && along.mignitude() >= flatness * across;
      score = std::min(score, along.mignitude() * box.length(axis) / total);
      guess = std::min(guess, middle_magnitude(along) * box.length(axis) / total);
    }
    if (serves) {
      int place = choice.proven_count++;
      for (; place > 0 && scores[place - 1] < score; --place) {
        scores[place] = scores[place - 1];
        choice.proven[place] = choice.proven[place - 1];
      }
      scores[place] = score;
      choice.proven[place] = axis;
    }
    if (guess > nearest) {
      nearest = guess;
      choice.likely = axis;
    }
  }
  return choice;
}

int likely_height(const Box& box, std::span<const Point> gradients) {
  int likely = 0;
  double nearest = -1;
  for (int axis = 0; axis < box.dimension; ++axis) {
    double guess = 1;
    for (const Point& gradient : gradients) {
      double total = 0;
      for (int other = 0; other < box.dimension; ++other)
        total += std::fabs(gradient[other]) * box.length(other);
      if (std::isfinite(total) && total > 0)
        guess = std::min(guess, std::fabs(gradient[axis]) * box.length(axis) / total);
    }
    if (guess > nearest) {
      nearest = guess;
      likely = axis;
    }
  }
  return likely;
}

}  // namespace rfm
