#include "quadrature/compression.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <span>

namespace rfm {
namespace {

int polynomial_count(int degree, int dimension) {
  int count = 1;
  for (int i = 1; i <= dimension; ++i) count = count * (degree + i) / i;
  return count;
}

// Legendre polynomials 0 … degree at t in [−1, 1], of unit mean square.
void add_legendre(double t, int degree, std::vector<double>& values) {
  values.assign(degree + 1, 1);
  if (degree > 0) values[1] = t;
  for (int k = 2; k <= degree; ++k)
    values[k] = ((2 * k - 1) * t * values[k - 1] - (k - 1) * values[k - 2]) / k;
  for (int k = 0; k <= degree; ++k) values[k] *= std::sqrt(2 * k + 1);
}

// One row per point, one column per polynomial; points are on [−1, 1].
Eigen::MatrixXd polynomials(int dimension, int degree, const std::vector<Point>& points) {
  Eigen::MatrixXd values(points.size(), polynomial_count(degree, dimension));
  std::array<std::vector<double>, 3> along;
  for (std::size_t i = 0; i < points.size(); ++i) {
    for (int axis = 0; axis < 3; ++axis)
      add_legendre(points[i][axis], axis < dimension ? degree : 0, along[axis]);
    int column = 0;
    for (int c = 0; c < static_cast<int>(along[2].size()); ++c)
      for (int b = 0; b < static_cast<int>(along[1].size()) && b + c <= degree; ++b)
        for (int a = 0; a + b + c <= degree; ++a)
          values(i, column++) = along[0][a] * along[1][b] * along[2][c];
  }
  return values;
}

// The points from `begin` on, scaled to [−1, 1] along each axis.
std::vector<Point> scaled_points(int dimension, int begin, const VolumePoints& points) {
  std::vector<Point> scaled(points.size() - begin, Point{});
  for (int axis = 0; axis < dimension; ++axis) {
    const std::span values(points.coordinates[axis].data() + begin, scaled.size());
    const auto [low, high] = std::ranges::minmax(values);
    if (!(high > low)) continue;
    for (std::size_t i = 0; i < scaled.size(); ++i)
      scaled[i][axis] = (values[i] - low) / (high - low) * 2 - 1;
  }
  return scaled;
}

// Moves `weights` along the columns of `null` until as many of them vanish as there are columns.
void eliminate(Eigen::MatrixXd& null, Eigen::VectorXd& weights) {
  for (int k = static_cast<int>(null.cols()) - 1; k >= 0; --k) {
    auto direction = null.col(k);
    // In both senses: the first weight that vanishes. The larger component is the better pivot.
    int pivot = -1;
    double best = 0;
    for (const double sense : {1.0, -1.0}) {
      int first = -1;
      double shortest = INFINITY;
      for (int i = 0; i < weights.size(); ++i) {
        const double slope = sense * direction[i];
        if (slope > 0 && weights[i] < shortest * slope) {
          shortest = weights[i] / slope;
          first = i;
        }
      }
      if (first >= 0 && std::fabs(direction[first]) > best) {
        best = std::fabs(direction[first]);
        pivot = first;
      }
    }
    if (pivot < 0) continue;
    weights -= (weights[pivot] / direction[pivot]) * direction;
    for (int other = 0; other < k; ++other) {
      null.col(other) -= (null(pivot, other) / direction[pivot]) * direction;
      null(pivot, other) = 0;
      null.col(other).normalize();
    }
    // Weights that have vanished stay so: all later directions are zero there.
    weights[pivot] = 0;
    weights = weights.cwiseMax(0);
  }
}

// Drops points from `kept` until no more are left than there are polynomials.
void reduce(int dimension, int degree, const std::vector<Point>& all, std::vector<int>& kept,
            std::vector<double>& weights) {
  std::vector<Point> points;
  for (const int i : kept) points.push_back(all[i]);
  const Eigen::MatrixXd values = polynomials(dimension, degree, points);
  const int count = static_cast<int>(values.rows()), free = count - static_cast<int>(values.cols());
  if (free <= 0) return;
  const Eigen::HouseholderQR<Eigen::MatrixXd> qr(values);
  Eigen::MatrixXd null = Eigen::MatrixXd::Zero(count, free);
  null.bottomRows(free).setIdentity();
  null.applyOnTheLeft(qr.householderQ());
  Eigen::VectorXd moved = Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  eliminate(null, moved);
  const Eigen::VectorXd moments =
      values.transpose() * Eigen::Map<const Eigen::VectorXd>(weights.data(), count);
  std::vector<int> rows;
  for (int i = 0; i < count; ++i)
    if (moved[i] > 0) rows.push_back(i);
  // Small pivots lose digits of the moments: the least change of the weights that mends them.
  const Eigen::MatrixXd left = values(rows, Eigen::all).transpose();
  const Eigen::VectorXd found = moved(rows);
  const Eigen::VectorXd mended = found + left.colPivHouseholderQr().solve(moments - left * found);
  const bool positive = mended.minCoeff() > 0;
  weights.resize(rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    kept[i] = kept[rows[i]];
    weights[i] = positive ? mended[i] : found[i];
  }
  kept.resize(rows.size());
}

// Takes out what rounding has added to the moments on the way, where weights stay positive.
void refine(int dimension, int degree, const std::vector<Point>& all,
            std::span<const double> all_weights, const std::vector<int>& kept,
            std::vector<double>& weights) {
  constexpr std::size_t batch = 256;
  Eigen::VectorXd missing = Eigen::VectorXd::Zero(polynomial_count(degree, dimension));
  for (std::size_t i = 0; i < all.size(); i += batch) {
    const std::size_t size = std::min(batch, all.size() - i);
    const std::vector<Point> part(all.begin() + i, all.begin() + i + size);
    missing += polynomials(dimension, degree, part).transpose() *
               Eigen::Map<const Eigen::VectorXd>(all_weights.data() + i, size);
  }
  std::vector<Point> points;
  for (const int i : kept) points.push_back(all[i]);
  const Eigen::MatrixXd moments = polynomials(dimension, degree, points).transpose();
  Eigen::Map<Eigen::VectorXd> own(weights.data(), static_cast<Eigen::Index>(weights.size()));
  missing -= moments * own;
  const Eigen::VectorXd refined = own + moments.completeOrthogonalDecomposition().solve(missing);
  if (refined.minCoeff() > 0) own = refined;
}

}  // namespace

int compressed_degree(int points, int dimension) {
  int most = 1;
  for (int axis = 0; axis < dimension; ++axis) most *= points;
  int degree = 0;
  while (polynomial_count(degree + 1, dimension) <= most) ++degree;
  return degree;
}

void compress(int dimension, int degree, int begin, VolumePoints& points) {
  const int most = polynomial_count(degree, dimension);
  const int count = points.size() - begin;
  if (count <= most) return;
  const std::vector<Point> all = scaled_points(dimension, begin, points);
  // Some points at a time join those that are left of the earlier ones: time is linear in `count`.
  std::vector<int> kept;
  std::vector<double> weights;
  for (int next = 0; next < count;) {
    while (next < count && static_cast<int>(kept.size()) < 2 * most) {
      kept.push_back(next);
      weights.push_back(points.weights[begin + next++]);
    }
    reduce(dimension, degree, all, kept, weights);
  }
  const std::span all_weights(points.weights.data() + begin, all.size());
  refine(dimension, degree, all, all_weights, kept, weights);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    for (int axis = 0; axis < dimension; ++axis)
      points.coordinates[axis][begin + i] = points.coordinates[axis][begin + kept[i]];
    points.weights[begin + i] = weights[i];
  }
  points.resize(begin + static_cast<int>(kept.size()));
}

}  // namespace rfm
