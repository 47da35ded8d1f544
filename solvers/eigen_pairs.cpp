#include "solvers/eigen_pairs.hpp"

#include <Spectra/SymGEigsShiftSolver.h>
#include <fmt/format.h>

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/error.hpp"
#include "solvers/symmetric_factorization.hpp"

namespace rfm {
namespace {

constexpr int spare = 3;  // eigenvalues beyond those wanted, among which a gap is looked for
constexpr int most_rounds = 8;
constexpr double largest_residual = 1e-6;  // of a pair that counts as found

Eigen::MatrixXd product(const SparseMatrix& lower, const Eigen::MatrixXd& vectors) {
  return lower.selfadjointView<Eigen::Lower>() * vectors;
}

[[noreturn]] void refuse_mass() {
  throw ComputationError("the modes could not be told apart: the mass is not positive");
}

// How far below the first eigenvalue wanted σ lies: about the smallest eigenvalue, from the ratios
// of diagonals (of order h^−order) and the number of unknowns. The median, for splines on slivers
// have ratios of any size.
double margin(const SparseMatrix& stiffness, const SparseMatrix& mass,
              const EigenOptions& options) {
  const Eigen::VectorXd k = stiffness.diagonal(), m = mass.diagonal();
  std::vector<double> ratios;
  for (Eigen::Index i = 0; i < k.size(); ++i)
    if (m[i] > 0 && std::isfinite(k[i] / m[i])) ratios.push_back(std::abs(k[i] / m[i]));
  if (ratios.empty()) throw ComputationError("nothing has a mass, so that there are no modes");
  const auto middle = ratios.begin() + static_cast<std::ptrdiff_t>(ratios.size() / 2);
  std::nth_element(ratios.begin(), middle, ratios.end());
  const double scale =
      *middle / std::pow(double(k.size()), double(options.order) / std::max(options.dimension, 1));
  return scale > 0 ? scale : 1.0;
}

// The two matrices, scaled.
struct Pencil {
  SparseMatrix stiffness, mass;
  Eigen::VectorXd factors;
  Eigen::Index size = 0;  // without dropped functions
  const EigenOptions& options;

  Pencil(const SparseMatrix& k, const SparseMatrix& m, double sigma, const EigenOptions& given)
      : options(given) {
    const DiagonalScaling scaling(SparseMatrix(k + std::abs(sigma) * m));
    factors = scaling.factors;
    size = k.rows() - scaling.dropped;
    stiffness = scaling.apply(k);
    mass = scaling.apply(m);
    // A function without support is an equation of its own, without mass.
    for (Eigen::Index i = 0; i < factors.size(); ++i)
      if (factors[i] == 0) mass.coeffRef(i, i) = 0;
  }

  SymmetricFactorization factorized(double sigma) const {
    const SparseMatrix shifted = stiffness - sigma * mass;
    if (!options.elimination_order.empty())
      return SymmetricFactorization(shifted, options.elimination_order);
    return SymmetricFactorization(shifted,
                                  options.dimension >= 3 ? Ordering::metis : Ordering::amd);
  }
};

// x ↦ (I − X Xᵀ M) (K − σ M)⁻¹ x, in the form that Spectra asks for; X are the vectors known.
class DeflatedInverse {
 public:
  using Scalar = double;

  DeflatedInverse(const SymmetricFactorization& factors, const SparseMatrix& mass,
                  const Eigen::MatrixXd& known)
      : factors_(factors), known_(known), weighted_(product(mass, known)) {}

  Eigen::Index rows() const { return weighted_.rows(); }
  Eigen::Index cols() const { return rows(); }
  void set_shift(double) {}  // the factorisation knows it
  void perform_op(const double* from, double* to) const {
    Eigen::Map<Eigen::VectorXd> result(to, rows());
    result = factors_.solve(Eigen::Map<const Eigen::VectorXd>(from, rows()));
    if (known_.cols() > 0) result -= known_ * (weighted_.transpose() * result);
  }

 private:
  const SymmetricFactorization& factors_;
  const Eigen::MatrixXd& known_;
  Eigen::MatrixXd weighted_;
};

struct MassProduct {
  using Scalar = double;
  const SparseMatrix& lower;

  Eigen::Index rows() const { return lower.rows(); }
  Eigen::Index cols() const { return lower.cols(); }
  void perform_op(const double* from, double* to) const {
    Eigen::Map<Eigen::VectorXd>(to, rows()) =
        lower.selfadjointView<Eigen::Lower>() * Eigen::Map<const Eigen::VectorXd>(from, rows());
  }
};

// Up to `count` vectors of the largest 1/(λ − σ) in the complement of `known`.
Eigen::MatrixXd lanczos(const Pencil& pencil, const SymmetricFactorization& factors,
                        const Eigen::MatrixXd& known, int count, double sigma) {
  const int room = static_cast<int>(pencil.size - known.cols());
  count = std::min(count, room - 1);
  if (count < 1) return Eigen::MatrixXd::Random(pencil.mass.rows(), std::max(room, 0));
  DeflatedInverse inverse(factors, pencil.mass, known);
  MassProduct mass{pencil.mass};
  const int basis = std::min(room, std::max(2 * count + 1, 24));
  Spectra::SymGEigsShiftSolver<DeflatedInverse, MassProduct, Spectra::GEigsMode::ShiftInvert>
      solver(inverse, mass, count, basis, sigma);
  try {
    solver.init();
    solver.compute(Spectra::SortRule::LargestAlge, 300, pencil.options.tolerance,
                   Spectra::SortRule::LargestAlge);
  } catch (const std::exception&) {  // the square root of a negative mass
    refuse_mass();
  }
  return solver.eigenvectors();
}

struct Ritz {
  Eigen::VectorXd values;
  Eigen::MatrixXd vectors;
};

// A step of inverse iteration, and W. Ritz's method in the span of the result.
Ritz refined(const Pencil& pencil, const SymmetricFactorization& factors,
             const Eigen::MatrixXd& start) {
  Eigen::MatrixXd vectors = product(pencil.mass, start);
  for (auto vector : vectors.colwise()) vector = factors.solve(vector).normalized();
  const Eigen::MatrixXd k = vectors.transpose() * product(pencil.stiffness, vectors);
  const Eigen::MatrixXd m = vectors.transpose() * product(pencil.mass, vectors);
  const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> small(0.5 * (k + k.transpose()),
                                                                        0.5 * (m + m.transpose()));
  if (small.info() != Eigen::Success || !small.eigenvalues().allFinite()) refuse_mass();
  return {small.eigenvalues(), vectors * small.eigenvectors()};
}

// The middle of the widest gap above the eigenvalues wanted; `first` is the number of the first.
double place_in_gap(const Eigen::VectorXd& values, Eigen::Index first, int count, double sigma) {
  const Eigen::Index last = first + count - 1;
  double widest = 0;
  double place = values[values.size() - 1] + 0.5 * (values[values.size() - 1] - sigma);
  for (Eigen::Index i = last; i + 1 < values.size(); ++i)
    if (values[i + 1] - values[i] > widest) {
      widest = values[i + 1] - values[i];
      place = values[i] + 0.5 * widest;
    }
  return place;
}

void require_consistent(const SparseMatrix& stiffness, const SparseMatrix& mass,
                        const EigenOptions& options) {
  if (stiffness.rows() != stiffness.cols() || mass.rows() != mass.cols() ||
      stiffness.rows() != mass.rows())
    throw InvalidArgument("stiffness and mass must be square and of one size");
  if (options.count < 1) throw InvalidArgument("the number of eigenvalues must be positive");
}

}  // namespace

EigenPairs eigen_pairs(const SparseMatrix& stiffness, const SparseMatrix& given_mass,
                       const EigenOptions& options) {
  require_consistent(stiffness, given_mass, options);
  // In units of the margin the eigenvalues wanted are of order one, whatever the units of the
  // matrices: Spectra takes all vectors for converged where 1/(λ − σ) is below ε^(2/3).
  const double unit = margin(stiffness, given_mass, options);
  const SparseMatrix mass = unit * given_mass;
  const double shift = options.shift / unit, sigma = shift - 1;
  const Pencil pencil(stiffness, mass, sigma, options);
  if (options.count > pencil.size)
    throw ComputationError(
        fmt::format("{} unknowns have no {} modes: use more cells", pencil.size, options.count));
  const SymmetricFactorization factors = pencil.factorized(sigma);
  const auto below_sigma = static_cast<Eigen::Index>(factors.negative_eigenvalues());
  if (options.count > pencil.size - below_sigma)
    throw ComputationError(
        fmt::format("{} of the {} eigenvalues lie below the shift {:.6g}, so that there are no {} "
                    "from there on: is the stiffness negative?",
                    below_sigma, pencil.size, options.shift, options.count));
  const double least = shift - 1e-6;  // an eigenvalue at the shift counts

  Ritz ritz{{}, Eigen::MatrixXd(stiffness.rows(), 0)};
  EigenPairs result;
  double upper = 0;
  Eigen::Index first = 0;
  for (int round = 0, more = options.count + spare; round < most_rounds && more > 0; ++round) {
    const Eigen::MatrixXd found = lanczos(pencil, factors, ritz.vectors, more, sigma);
    Eigen::MatrixXd span(stiffness.rows(), ritz.vectors.cols() + found.cols());
    span << ritz.vectors, found;
    if (span.cols() == 0)
      throw ComputationError(
          "no mode was found: the mass, or the stiffness, differs too much from place to place");
    ritz = refined(pencil, factors, span);
    first = (ritz.values.array() < least).count();
    const auto from_shift = static_cast<int>(ritz.values.size() - first);
    more = options.count + spare - from_shift;
    if (from_shift < options.count) continue;
    upper = place_in_gap(ritz.values, first, options.count, sigma);
    result.found = static_cast<int>((ritz.values.array() < upper).count() - first);
    result.present = pencil.factorized(upper).negative_eigenvalues() -
                     factors.negative_eigenvalues() - static_cast<int>(first);
    more = result.present - result.found;
  }
  result.upper = unit * upper;
  if (result.found < options.count || result.found != result.present)
    throw ComputationError(
        fmt::format("{} of {} eigenvalues were found, though there are {} below {:.6g}",
                    result.found, options.count, result.present, result.upper));

  for (Eigen::Index i = first; i < first + options.count; ++i) {
    const double value = ritz.values[i];
    const Eigen::VectorXd vector = ritz.vectors.col(i);
    const Eigen::VectorXd k = product(pencil.stiffness, vector), m = product(pencil.mass, vector);
    const double residual = (k - value * m).norm() / (k - sigma * m).norm();
    if (!(residual <= largest_residual))
      throw ComputationError(fmt::format(
          "eigenvalue {} was not found: that of {:.6g} has a residual of {:.1e}, and {:.0e} is "
          "allowed",
          i - first, unit * value, residual, largest_residual));
    result.pairs.push_back(
        {unit * value, residual, std::sqrt(unit) * pencil.factors.cwiseProduct(vector)});
  }
  return result;
}

}  // namespace rfm
