#include "core/shortest_way.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

double length(const Point& v) { return std::hypot(v[0], v[1], v[2]); }

Box box_of(const Point& point, int dimension) { return {dimension, point, point}; }

}  // namespace

ShortestWay::ShortestWay(const RegionPart& a, const RegionPart& b)
    : parts_{&a, &b}, dimension_(a.box.dimension), ends_{a.box.center(), b.box.center()} {
  size_ = std::max(a.box.longest_side(), b.box.longest_side());
  for (int axis = 0; axis < dimension_; ++axis)
    size_ = std::max(size_, std::fabs(ends_[0][axis] - ends_[1][axis]));
  for (const int side : {0, 1}) add_conditions(side);
  evaluate();
  constexpr int most_steps = 12;
  for (int step = 0; step < most_steps && improve(); ++step) evaluate();
  evaluate();
  stiffen();
}

void ShortestWay::add_conditions(int side) {
  const RegionPart& part = *parts_[side];
  const Point& center = ends_[side];
  std::vector<std::pair<double, Condition>> found;
  for (const NecessarySign& sign : part.signs) {
    if (!part.second->exist(sign.primitive)) continue;
    const LevelFunction& level = part.region->level(sign.primitive);
    const FunctionBounds bounds = level.bounds(part.box);
    const double steepness =
        std::hypot(bounds.gradient[0].magnitude(), bounds.gradient[1].magnitude(),
                   bounds.gradient[2].magnitude());
    if (!bounds.smooth || !(steepness > 0) || !std::isfinite(steepness)) continue;
    const double value = level.value(center);
    if (!std::isfinite(value)) continue;
    Condition condition{};
    condition.side = side;
    condition.primitive = sign.primitive;
    condition.factor = sign.sign / steepness;
    found.emplace_back(condition.factor * value, condition);
  }
  std::sort(found.begin(), found.end(),
            [](const auto& first, const auto& second) { return first.first < second.first; });
  if (found.size() > most_conditions) found.resize(most_conditions);
  for (const auto& [distance, condition] : found) conditions_.push_back(condition);
}

void ShortestWay::evaluate() {
  for (Condition& condition : conditions_) {
    const RegionPart& part = *parts_[condition.side];
    const Point& end = ends_[condition.side];
    condition.value =
        condition.factor *
        part.region->level(condition.primitive).value_and_gradient(end, condition.slope);
    condition.second = part.second->at(condition.primitive, end);
    for (int i = 0; i < dimension_; ++i) {
      condition.slope[i] *= condition.factor;
      for (int j = 0; j < dimension_; ++j) condition.second[i][j] *= condition.factor;
    }
  }
}

void ShortestWay::stiffen() {
  for (Condition& condition : conditions_) {
    condition.stiffness = 0;
    const double square = condition.slope[0] * condition.slope[0] +
                          condition.slope[1] * condition.slope[1] +
                          condition.slope[2] * condition.slope[2];
    if (condition.multiplier <= 0 || !(square > 0)) continue;
    double along = 0;  // second derivative of the sum of all −λg along the normal
    for (const Condition& other : conditions_)
      if (other.side == condition.side)
        for (int i = 0; i < dimension_; ++i)
          for (int j = 0; j < dimension_; ++j)
            along -= other.multiplier * other.second[i][j] * condition.slope[i] *
                     condition.slope[j] / square;
    // Half as much again as it takes: bounds over boxes have a width.
    condition.stiffness = 1.5 * std::max(0.0, -along) / square;
  }
}

bool ShortestWay::improve() {
  stiffen();
  const int n = dimension_;
  QuadraticModel::Matrix<double> matrix{};
  QuadraticModel::Vector<double> gradient{};
  for (int i = 0; i < n; ++i) {
    matrix[i][i] = matrix[n + i][n + i] = 2;
    matrix[n + i][i] = -2;
    gradient[i] = 2 * (ends_[0][i] - ends_[1][i]);
    gradient[n + i] = -gradient[i];
  }
  std::vector<LinearCondition> linear;
  for (const Condition& condition : conditions_) {
    const int first = condition.side * n;
    LinearCondition& row = linear.emplace_back();
    row.value = condition.value;
    for (int i = 0; i < n; ++i) {
      row.slope[first + i] = condition.slope[i];
      gradient[first + i] += condition.stiffness * condition.value * condition.slope[i];
      for (int j = 0; j <= i; ++j)
        matrix[first + i][first + j] +=
            condition.stiffness * condition.slope[i] * condition.slope[j] -
            condition.multiplier * condition.second[i][j];
    }
  }
  // A common translation costs nothing, which must not make of it a direction without bound.
  for (int i = 0; i < 2 * n; ++i) matrix[i][i] += 1e-6;
  const QuadraticMinimum minimum =
      constrained_minimum(ShiftedCholesky(matrix, 2 * n), gradient, 2 * n, linear);
  double moved = 0;
  for (int i = 0; i < 2 * n; ++i) {
    if (!std::isfinite(minimum.step[i])) return false;
    moved = std::max(moved, std::fabs(minimum.step[i]));
  }
  for (std::size_t k = 0; k < conditions_.size(); ++k)
    conditions_[k].multiplier = minimum.multipliers[k];
  for (const int side : {0, 1}) {
    const Box& box = parts_[side]->box;
    for (int i = 0; i < n; ++i) {
      const double margin = box.length(i);
      ends_[side][i] = std::clamp(ends_[side][i] + minimum.step[side * n + i], box.low[i] - margin,
                                  box.high[i] + margin);
    }
  }
  return moved > 1e-14 * size_;
}

Point ShortestWay::inwards(int side) const {
  Point direction{};
  for (const Condition& condition : conditions_)
    if (condition.side == side && condition.multiplier > 0)
      for (int i = 0; i < dimension_; ++i)
        direction[i] += condition.slope[i] / length(condition.slope);
  return direction;
}

// −λ g (1 − κ g) by its expansion about a point of the box; false where it is not twice
// differentiable.
bool ShortestWay::add_to(QuadraticModel& model, const Condition& condition, const Point& about,
                         bool stiffened) const {
  const RegionPart& part = *parts_[condition.side];
  const LevelFunction& level = part.region->level(condition.primitive);
  const Interval factor(condition.factor), multiplier(condition.multiplier);
  const FunctionBounds here = level.bounds(box_of(about, dimension_));
  const FunctionBounds everywhere = level.bounds(part.box);
  const auto second = part.second->bounds(condition.primitive, part.box);
  if (!here.smooth || !everywhere.smooth || !second) return false;
  const Interval value = factor * level.value_bounds(box_of(about, dimension_));
  const Interval range = factor * everywhere.value;
  // g (1 − κ g) ≥ 0 wherever 0 ≤ g ≤ 1/κ.
  double kappa = stiffened ? 0.5 * condition.stiffness / condition.multiplier : 0;
  if (range.high > 0) kappa = std::min(kappa, (Interval(1) / Interval(range.high)).low);
  model.value = model.value - multiplier * value * (Interval(1) - Interval(kappa) * value);
  const Interval here_factor = multiplier * (Interval(1) - Interval(2 * kappa) * value);
  const Interval range_factor = multiplier * (Interval(1) - Interval(2 * kappa) * range);
  const Interval square_factor = Interval(2 * kappa) * multiplier;
  const int first = condition.side * dimension_;
  for (int i = 0; i < dimension_; ++i) {
    model.gradient[first + i] = model.gradient[first + i] - here_factor * factor * here.gradient[i];
    for (int j = 0; j < dimension_; ++j)
      model.hessian[first + i][first + j] =
          model.hessian[first + i][first + j] - range_factor * factor * (*second)[i][j] +
          square_factor *
              (i == j ? square(factor * everywhere.gradient[i])
                      : factor * everywhere.gradient[i] * (factor * everywhere.gradient[j]));
  }
  return true;
}

double ShortestWay::at_least() const {
  const bool is_stiffened = std::ranges::any_of(
      conditions_, [](const Condition& condition) { return condition.stiffness > 0; });
  return std::max(at_least(false), is_stiffened ? at_least(true) : 0.0);
}

double ShortestWay::at_least(bool stiffened) const {
  const int n = dimension_;
  QuadraticModel model;
  model.size = 2 * n;
  Point about[2]{};
  for (const int side : {0, 1})
    for (int i = 0; i < n; ++i) {
      const Box& box = parts_[side]->box;
      about[side][i] = std::clamp(ends_[side][i], box.low[i], box.high[i]);
      model.range[side * n + i] = box.interval(i) - Interval(about[side][i]);
    }
  for (int i = 0; i < n; ++i) {
    const Interval apart = Interval(about[0][i]) - Interval(about[1][i]);
    model.value = model.value + square(apart);
    model.gradient[i] = Interval(2) * apart;
    model.gradient[n + i] = Interval(-2) * apart;
    model.hessian[i][i] = model.hessian[n + i][n + i] = Interval(2);
    model.hessian[i][n + i] = model.hessian[n + i][i] = Interval(-2);
  }
  for (const Condition& condition : conditions_)
    if (condition.multiplier > 0 && !add_to(model, condition, about[condition.side], stiffened))
      return 0;
  const double square = lower_bound(model);
  return square > 0 ? sqrt(Interval(square)).low : 0;
}

}  // namespace rfm
