#include "problems/eigen_study.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/error.hpp"
#include "solvers/eigen_pairs.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// Eigenvalues of one eigenspace: rounding may part them by so much, discretisation by more.
constexpr double same = 1e-9;
constexpr double no_moment = 1e-4;
constexpr int highest_moment = 6;

// The exponents of the monomials up to a degree, ascending; x first.
std::vector<MultiIndex> exponents(int dimension) {
  std::vector<MultiIndex> result;
  for (int total = 0; total <= highest_moment; ++total)
    for (int i = total; i >= 0; --i)
      for (int j = total - i; j >= 0; --j) {
        const MultiIndex alpha{std::uint8_t(i), std::uint8_t(j), std::uint8_t(total - i - j)};
        if ((dimension > 1 || alpha[1] == 0) && (dimension > 2 || alpha[2] == 0))
          result.push_back(alpha);
      }
  return result;
}

Field monomial(const MultiIndex& alpha, const Box& box) {
  Field product = 1.0;
  for (int axis = 0; axis < box.dimension; ++axis) {
    const double middle = 0.5 * (box.low[axis] + box.high[axis]);
    const Field xi = Field(2 / box.longest_side()) * (coordinate(axis) - middle);
    for (int i = 0; i < alpha[axis]; ++i) product = product * xi;
  }
  return product;
}

// ∫ m φ_c f for every function φ of the spaces, with f a monomial: the product of the masses and
// the state whose component c is f, as loads.
class Moments {
 public:
  Moments(const Equations& equations, const Box& box)
      : equations_(equations),
        box_(box),
        exponents_(exponents(box.dimension)),
        components_(equations.structures().size()) {
    for (const Contribution& mass : equations.terms().mass)
      for (const QuadraticEnergy::Entry& entry : mass.energy.stiffness())
        if (entry.row == entry.column)
          total_ += integrate(entry.coefficient, equations.rule(), {mass.place, mass.numbers});
  }

  std::size_t count() const { return exponents_.size() * components_; }
  const Eigen::VectorXd& operator[](std::size_t i) {
    if (i == known_.size())
      known_.push_back(assembled(monomial(exponents_[i / components_], box_),
                                 static_cast<int>(i % components_)));
    return known_[i];
  }
  /// ∫ m: moments of modes of unit mass are less than its root.
  double total() const { return total_; }

 private:
  Eigen::VectorXd assembled(const Field& factor, int component) const {
    std::vector<Contribution> loads;
    for (const Contribution& mass : equations_.terms().mass) {
      Contribution load{{}, mass.place, mass.numbers, mass.where};
      const std::vector<Slot>& slots = mass.energy.slots();
      for (const QuadraticEnergy::Entry& entry : mass.energy.stiffness()) {
        if (slots[entry.column].component == component)
          load.energy.add_load(slots[entry.row], entry.coefficient * factor);
        if (entry.row != entry.column && slots[entry.row].component == component)
          load.energy.add_load(slots[entry.column], entry.coefficient * factor);
      }
      loads.push_back(std::move(load));
    }
    return equations_.assembled(loads).right_hand_side;
  }

  const Equations& equations_;
  Box box_;
  std::vector<MultiIndex> exponents_;
  std::size_t components_;
  std::vector<Eigen::VectorXd> known_;
  double total_ = 0;
};

// Turns the columns, modes of one eigenvalue, so that their moments decide them.
Eigen::MatrixXd turned(const Eigen::MatrixXd& modes, Moments& moments) {
  const Eigen::Index count = modes.cols();
  Eigen::MatrixXd turn(count, 0);
  const auto add = [&](Eigen::VectorXd direction, double least) {
    for (int twice = 0; twice < 2; ++twice) direction -= turn * (turn.transpose() * direction);
    if (!(direction.norm() > least)) return;
    turn.conservativeResize(Eigen::NoChange, turn.cols() + 1);
    turn.rightCols(1) = direction.normalized();
  };
  for (std::size_t i = 0; i < moments.count() && turn.cols() < count; ++i)
    add(modes.transpose() * moments[i], no_moment * std::sqrt(moments.total()));
  for (Eigen::Index i = 0; i < count && turn.cols() < count; ++i)
    add(Eigen::VectorXd::Unit(count, i), 0.5 / std::sqrt(double(count)));
  return modes * turn;
}

int derivative_order(const Equations& equations) {
  int order = 1;
  for (const Contribution& part : equations.terms().stiffness)
    for (const Slot& slot : part.energy.slots()) order = std::max(order, degree(slot.derivative));
  return order;
}

// The lower triangle. Forms that follow from no energy may be symmetric nevertheless, as those of
// Nitsche's method are.
SparseMatrix symmetric(const LinearSystem& system) {
  if (system.symmetric) return system.matrix;
  const SparseMatrix transposed = system.matrix.transpose();
  if ((system.matrix - transposed).norm() > 1e-10 * system.matrix.norm())
    throw ComputationError(
        "modes are those of a symmetric stiffness: a weak form here follows from no energy");
  return system.matrix.triangularView<Eigen::Lower>();
}

}  // namespace

std::vector<double> EigenResult::frequencies() const {
  std::vector<double> result;
  // Of a body that nothing holds all that are wanted may be 0.
  const double size = values.empty() ? 0 : std::max(std::abs(values.back()), std::abs(upper));
  for (const double value : values)
    result.push_back(std::abs(value) < 1e-10 * size ? 0
                                                    : std::sqrt(value) / (2 * std::numbers::pi));
  return result;
}

EigenResult find_modes(const Equations& equations, const Study& study, const Box& box) {
  EigenOptions options;
  options.count = study.count;
  options.shift = study.shift;
  options.dimension = box.dimension;
  options.order = 2 * derivative_order(equations);
  options.elimination_order = equations.steady().elimination_order;
  const EigenPairs found = eigen_pairs(symmetric(equations.steady()), equations.mass(), options);

  EigenResult result;
  result.present = found.present;
  result.upper = found.upper;
  Moments moments(equations, box);
  for (std::size_t first = 0, last = 1; first < found.pairs.size(); first = last++) {
    const double value = found.pairs[first].value;
    while (last < found.pairs.size() &&
           found.pairs[last].value - value <= same * (std::abs(value) + std::abs(found.upper)))
      ++last;
    Eigen::MatrixXd modes(equations.size(), static_cast<Eigen::Index>(last - first));
    for (std::size_t i = first; i < last; ++i)
      modes.col(static_cast<Eigen::Index>(i - first)) = found.pairs[i].vector;
    const Eigen::MatrixXd chosen = turned(modes, moments);
    for (Eigen::Index i = 0; i < chosen.cols(); ++i)
      result.modes.push_back(equations.fields(chosen.col(i)));
  }
  for (const EigenPair& pair : found.pairs) {
    result.values.push_back(pair.value);
    result.residuals.push_back(pair.residual);
  }
  return result;
}

double eigenvalue_error(const std::vector<double>& values, const std::vector<double>& exact) {
  double largest = 0, size = 0;
  for (const double value : exact) size = std::max(size, std::abs(value));
  for (std::size_t i = 0; i < std::min(values.size(), exact.size()); ++i)
    largest = std::max(
        largest, std::abs(values[i] - exact[i]) / (exact[i] != 0 ? std::abs(exact[i]) : size));
  return largest;
}

}  // namespace rfm
