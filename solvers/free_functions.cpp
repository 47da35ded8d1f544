#include "solvers/free_functions.hpp"

#include <fmt/format.h>

#include <Eigen/Cholesky>
#include <cmath>
#include <random>

#include "core/grid_splines.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// Whether a constant of the function of an unknown is one of the unknown, and of no other.
bool is_free(std::span<const Structure> structures, int unknown) {
  if (!structures[unknown].inhomogeneous().is_constant(0)) return false;
  int uses = 0;
  bool is_itself = false;
  for (std::size_t c = 0; c < structures.size(); ++c)
    for (const Structure::Term& term : structures[c].terms()) {
      if (term.unknown != unknown) continue;
      ++uses;
      is_itself = static_cast<int>(c) == unknown && degree(term.derivative) == 0 &&
                  term.coefficient.is_constant(1);
    }
  return uses == 1 && is_itself;
}

// The coefficients of a coordinate.
double coordinate_of(const TensorProductSpace& space, int function, int axis) {
  return greville_point(space.grid(), axis, space.degree(),
                        space.place(space.spline_of_function(function))[axis]);
}

// The coefficients of an axis' coordinate, or of 1 for −1, in the constant among the functions of a
// space and one that is linear along the axis; nothing where there are no such.
std::optional<Eigen::VectorXd> linear_along(const GlobalSpace& space, int axis) {
  constexpr int count = 12;
  const Box box = space.valid();
  std::mt19937 engine(1);
  std::array<std::vector<double>, 3> points;
  for (int d = 0; d < 3; ++d)
    for (int q = 0; q < count; ++q)
      points[d].push_back(d < space.dimension()
                              ? box.low[d] +
                                    box.length(d) * (static_cast<double>(engine()) / 0x1p32)
                              : 0);
  Eigen::MatrixXd values(space.size(), count);
  space.evaluate({points[0].data(), points[1].data(), points[2].data()}, count, {}, values.data());
  // a + b f is the wanted function at all points: from two of them, and checked at the others.
  const auto is_close = [&](double a, double b) { return std::abs(a - b) < 1e-12 * std::abs(b); };
  Eigen::Index one = -1;
  for (Eigen::Index f = 0; f < values.rows() && one < 0; ++f) {
    const double value = values(f, 0);
    if (value != 0 && (values.row(f).array() - value).abs().maxCoeff() < 1e-13 * std::abs(value))
      one = f;
  }
  if (one < 0) return std::nullopt;
  Eigen::VectorXd result = Eigen::VectorXd::Zero(values.rows());
  result[one] = 1 / values(one, 0);
  if (axis < 0) return result;
  const std::vector<double>& x = points[axis];
  for (Eigen::Index f = 0; f < values.rows(); ++f) {
    const double difference = values(f, 1) - values(f, 0);
    if (difference == 0) continue;
    const double slope = (x[1] - x[0]) / difference, level = x[0] - slope * values(f, 0);
    bool fits = true;
    for (int q = 0; q < count; ++q)
      fits = fits && is_close(level + slope * values(f, q) + 2 * box.length(axis),
                              x[q] + 2 * box.length(axis));
    if (!fits) continue;
    result *= level;
    result[f] += slope;
    return result;
  }
  return std::nullopt;
}

Field inner(const std::vector<Field>& a, const std::vector<Field>& b) {
  Field sum = 0.0;
  for (std::size_t c = 0; c < a.size(); ++c) sum = sum + product_or_nothing(a[c], b[c]);
  return sum;
}

}  // namespace

FreeFunctions::FreeFunctions(std::span<const Structure> structures,
                             std::span<const TensorProductSpace> spaces) {
  std::vector<Eigen::Index> first{0};
  for (const TensorProductSpace& space : spaces) first.push_back(first.back() + space.size());
  const auto of = [&](int unknown, int axis) -> std::optional<Eigen::VectorXd> {
    const TensorProductSpace& space = spaces[unknown];
    Eigen::VectorXd own = Eigen::VectorXd::Ones(space.size());
    if (axis >= 0)
      for (int f = 0; f < space.size(); ++f) own[f] = coordinate_of(space, f, axis);
    return own;
  };
  collect(structures, first, spaces.empty() ? 0 : spaces[0].dimension(), of);
}

FreeFunctions::FreeFunctions(std::span<const Structure> structures, const GlobalSpaces& spaces) {
  std::vector<Eigen::Index> first{0};
  for (const auto& space : spaces) first.push_back(first.back() + space->size());
  const auto of = [&](int unknown, int axis) { return linear_along(*spaces[unknown], axis); };
  collect(structures, first, spaces.empty() ? 0 : spaces[0]->dimension(), of);
}

void FreeFunctions::collect(std::span<const Structure> structures,
                            const std::vector<Eigen::Index>& first, int dimension,
                            const Coefficients& of) {
  coefficients_.resize(first.back(), 0);
  const int count = static_cast<int>(structures.size());
  if (first.size() < structures.size() + 1) return;
  const std::vector<Field> nothing(structures.size(), 0.0);
  std::vector<bool> free;
  for (int c = 0; c < count; ++c) {
    free.push_back(is_free(structures, c));
    const auto one = free[c] ? of(c, -1) : std::nullopt;
    if (!one) continue;
    Function constant{{c}, nothing};
    constant.components[c] = 1.0;
    Eigen::VectorXd own = Eigen::VectorXd::Zero(first.back());
    own.segment(first[c], one->size()) = *one;
    add(std::move(constant), std::move(own));
  }
  for (int a = 0; a < dimension && count >= dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) {
      const auto of_a = free[a] && free[b] ? of(a, b) : std::nullopt;
      const auto of_b = of_a ? of(b, a) : std::nullopt;
      if (!of_b) continue;
      Function rotation{{a, b}, nothing};
      rotation.components[a] = -coordinate(b);
      rotation.components[b] = coordinate(a);
      Eigen::VectorXd own = Eigen::VectorXd::Zero(first.back());
      own.segment(first[a], of_a->size()) = -*of_a;
      own.segment(first[b], of_b->size()) = *of_b;
      add(std::move(rotation), std::move(own));
    }
}

void FreeFunctions::add(Function function, Eigen::VectorXd coefficients) {
  functions_.push_back(std::move(function));
  coefficients_.conservativeResize(Eigen::NoChange, coefficients_.cols() + 1);
  coefficients_.rightCols(1) = coefficients;
}

std::string FreeFunctions::text(const Eigen::MatrixXd& kernel,
                                const std::vector<std::string>& names) const {
  std::string text;
  for (std::size_t i = 0; i < functions_.size(); ++i) {
    if (!(kernel.row(static_cast<Eigen::Index>(i)).norm() > 1e-8 * kernel.norm())) continue;
    const std::vector<int>& unknowns = functions_[i].unknowns;
    text +=
        (text.empty() ? "" : ", ") +
        (unknowns.size() == 1 ? "the level of " + names[unknowns[0]]
                              : "rotations of " + names[unknowns[0]] + ", " + names[unknowns[1]]);
  }
  return text;
}

std::string FreeFunctions::text(const UnbalancedLoads& loads,
                                const std::vector<std::string>& names) const {
  return fmt::format(
      "no steady solution exists: nothing fixes {}, and the loads on it do not balance (by {:.1e} "
      "of all loads)",
      text(loads.kernel(), names), loads.missing());
}

std::vector<Field> FreeFunctions::without(const Eigen::MatrixXd& kernel,
                                          std::vector<Field> unknowns,
                                          const DomainRule& rule) const {
  const Eigen::Index count = kernel.cols();
  if (count == 0) return unknowns;
  std::vector<std::vector<Field>> functions(count, std::vector<Field>(unknowns.size(), 0.0));
  for (Eigen::Index k = 0; k < count; ++k)
    for (std::size_t i = 0; i < functions_.size(); ++i)
      for (std::size_t c = 0; c < unknowns.size(); ++c)
        functions[k][c] =
            functions[k][c] + product_or_nothing(kernel(static_cast<Eigen::Index>(i), k),
                                                 functions_[i].components[c]);
  Eigen::MatrixXd products(count, count);
  Eigen::VectorXd shares(count);
  for (Eigen::Index k = 0; k < count; ++k) {
    shares[k] = integrate(inner(functions[k], unknowns), rule);
    for (Eigen::Index l = 0; l < count; ++l)
      products(k, l) = integrate(inner(functions[k], functions[l]), rule);
  }
  const Eigen::VectorXd amounts = products.ldlt().solve(shares);
  for (std::size_t c = 0; c < unknowns.size(); ++c)
    for (Eigen::Index k = 0; k < count; ++k)
      unknowns[c] = unknowns[c] - product_or_nothing(amounts[k], functions[k][c]);
  return unknowns;
}

}  // namespace rfm
