#include "solvers/free_functions.hpp"

#include <Eigen/Cholesky>

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
  coefficients_.resize(first.back(), 0);
  const int count = static_cast<int>(structures.size());
  if (spaces.size() < structures.size()) return;
  const std::vector<Field> nothing(structures.size(), 0.0);
  std::vector<bool> free;
  for (int c = 0; c < count; ++c) {
    free.push_back(is_free(structures, c));
    if (!free[c]) continue;
    Function constant{{c}, nothing};
    constant.components[c] = 1.0;
    Eigen::VectorXd own = Eigen::VectorXd::Zero(first.back());
    own.segment(first[c], spaces[c].size()).setOnes();
    add(std::move(constant), std::move(own));
  }
  const int dimension = spaces[0].dimension();
  for (int a = 0; a < dimension && count >= dimension; ++a)
    for (int b = a + 1; b < dimension; ++b) {
      if (!free[a] || !free[b]) continue;
      Function rotation{{a, b}, nothing};
      rotation.components[a] = -coordinate(b);
      rotation.components[b] = coordinate(a);
      Eigen::VectorXd own = Eigen::VectorXd::Zero(first.back());
      for (int f = 0; f < spaces[a].size(); ++f)
        own[first[a] + f] = -coordinate_of(spaces[a], f, b);
      for (int f = 0; f < spaces[b].size(); ++f) own[first[b] + f] = coordinate_of(spaces[b], f, a);
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
