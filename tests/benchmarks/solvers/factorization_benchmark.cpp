// Ways to solve the systems of equations, our own beside those of libraries: what is kept of our
// own is faster by the factors in docs/benchmarks.md.
#include <benchmark/benchmark.h>
#include <umfpack.h>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCholesky>
#include <cmath>
#include <map>

#include "solvers/conjugate_gradient.hpp"
#include "solvers/symmetric_factorization.hpp"
#include "tests/benchmarks/solvers/systems.hpp"

namespace rfm::benchmarks {
namespace {

// A system scaled by its diagonal, with its order of elimination.
struct Scaled {
  SparseMatrix lower;
  Eigen::VectorXd right_hand_side;
  std::vector<std::int64_t> order;

  explicit Scaled(const LinearSystem& system) : order(system.elimination_order) {
    const DiagonalScaling scaling(system.matrix);
    lower = scaling.apply(system.matrix);
    right_hand_side = scaling.factors.cwiseProduct(system.right_hand_side);
  }
  // Largest |b − A x| relative to b, so that no method is fast because it is wrong.
  void report(benchmark::State& state, const Eigen::VectorXd& solution) const {
    const Eigen::VectorXd rest = right_hand_side - lower.selfadjointView<Eigen::Lower>() * solution;
    state.counters["unknowns"] = double(right_hand_side.size());
    state.counters["residual"] = rest.norm() / right_hand_side.norm();
  }
};

enum class Enforced { by_structure, weakly };

template <Enforced enforced>
const Scaled& scaled_system(const benchmark::State& state) {
  static std::map<std::array<std::int64_t, 3>, Scaled> known;
  const std::array<std::int64_t, 3> key{state.range(0), state.range(1), state.range(2)};
  auto found = known.find(key);
  if (found == known.end()) {
    const auto make = enforced == Enforced::weakly ? weakly : by_structure;
    found = known.emplace(key, make(int(key[0]), int(key[1]), int(key[2])).system()).first;
  }
  return found->second;
}

// What the program does: nested dissection of the grid, CHOLMOD, our L D Lᵀ where it is indefinite.
template <Enforced enforced>
void direct(benchmark::State& state) {
  const Scaled& system = scaled_system<enforced>(state);
  Eigen::VectorXd solution;
  bool indefinite = false;
  for (auto _ : state) {
    const SymmetricFactorization factors(system.lower, system.order);
    solution = factors.solve(system.right_hand_side);
    indefinite = factors.method() == SymmetricFactorization::Method::ldlt;
  }
  system.report(state, solution);
  state.counters["indefinite"] = indefinite;
}

template <Ordering ordering>
void direct_ordered_by_library(benchmark::State& state) {
  const Scaled& system = scaled_system<Enforced::by_structure>(state);
  Eigen::VectorXd solution;
  for (auto _ : state)
    solution = SymmetricFactorization(system.lower, ordering).solve(system.right_hand_side);
  system.report(state, solution);
}

// Eigen's L D Lᵀ, given the same order of elimination.
void indefinite_eigen(benchmark::State& state) {
  const Scaled& system = scaled_system<Enforced::weakly>(state);
  Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, std::int64_t> to_new(
      static_cast<Eigen::Index>(system.order.size()));
  for (std::size_t i = 0; i < system.order.size(); ++i)
    to_new.indices()[system.order[i]] = static_cast<std::int64_t>(i);
  Eigen::VectorXd solution;
  for (auto _ : state) {
    SparseMatrix permuted(system.lower.rows(), system.lower.cols());
    permuted.selfadjointView<Eigen::Lower>() =
        system.lower.selfadjointView<Eigen::Lower>().twistedBy(to_new);
    const Eigen::SimplicialLDLT<SparseMatrix, Eigen::Lower, Eigen::NaturalOrdering<std::int64_t>>
        factors(permuted);
    const Eigen::VectorXd ordered = to_new * system.right_hand_side;
    solution = to_new.inverse() * Eigen::VectorXd(factors.solve(ordered));
  }
  system.report(state, solution);
}

// UMFPACK, L U of the whole matrix, symmetric strategy, given the same order or with its own.
template <bool given_order>
void indefinite_umfpack(benchmark::State& state) {
  const Scaled& system = scaled_system<Enforced::weakly>(state);
  const SparseMatrix full = system.lower.selfadjointView<Eigen::Lower>();
  const auto size = static_cast<SuiteSparse_long>(full.rows());
  Eigen::VectorXd solution(full.rows());
  for (auto _ : state) {
    double control[UMFPACK_CONTROL];
    umfpack_dl_defaults(control);
    control[UMFPACK_STRATEGY] = UMFPACK_STRATEGY_SYMMETRIC;
    void *symbolic = nullptr, *numeric = nullptr;
    if (given_order)
      umfpack_dl_qsymbolic(size, size, full.outerIndexPtr(), full.innerIndexPtr(), full.valuePtr(),
                           system.order.data(), &symbolic, control, nullptr);
    else
      umfpack_dl_symbolic(size, size, full.outerIndexPtr(), full.innerIndexPtr(), full.valuePtr(),
                          &symbolic, control, nullptr);
    umfpack_dl_numeric(full.outerIndexPtr(), full.innerIndexPtr(), full.valuePtr(), symbolic,
                       &numeric, control, nullptr);
    umfpack_dl_solve(UMFPACK_A, full.outerIndexPtr(), full.innerIndexPtr(), full.valuePtr(),
                     solution.data(), system.right_hand_side.data(), numeric, control, nullptr);
    umfpack_dl_free_symbolic(&symbolic);
    umfpack_dl_free_numeric(&numeric);
  }
  system.report(state, solution);
}

template <Enforced enforced>
void iterative(benchmark::State& state) {
  const Scaled& system = scaled_system<enforced>(state);
  ConjugateGradientResult result;
  for (auto _ : state)
    result = conjugate_gradient(system.lower, system.right_hand_side, 1e-12, 3000);
  system.report(state, result.solution);
  state.counters["iterations"] = result.iterations;
}

template <Enforced enforced>
void iterative_eigen(benchmark::State& state) {
  const Scaled& system = scaled_system<enforced>(state);
  Eigen::VectorXd solution;
  Eigen::ConjugateGradient<SparseMatrix, Eigen::Lower, Eigen::IdentityPreconditioner> solver;
  solver.setTolerance(1e-12);
  solver.setMaxIterations(3000);
  for (auto _ : state) solution = solver.compute(system.lower).solve(system.right_hand_side);
  system.report(state, solution);
  state.counters["iterations"] = double(solver.iterations());
}

void small_and_plane(benchmark::internal::Benchmark* benchmark) {
  benchmark->ArgNames({"dimension", "degree", "cells"})->Unit(benchmark::kMillisecond);
  benchmark->Args({2, 3, 32})->Args({2, 3, 128});
}
void plane_and_space(benchmark::internal::Benchmark* benchmark) {
  small_and_plane(benchmark);
  benchmark->Args({3, 2, 12});
}

BENCHMARK(direct<Enforced::by_structure>)->Apply(plane_and_space);
BENCHMARK(direct_ordered_by_library<Ordering::amd>)->Apply(plane_and_space);
BENCHMARK(direct_ordered_by_library<Ordering::metis>)->Apply(plane_and_space);
BENCHMARK(iterative<Enforced::by_structure>)->Apply(plane_and_space);
BENCHMARK(iterative_eigen<Enforced::by_structure>)->Apply(plane_and_space);
BENCHMARK(direct<Enforced::weakly>)->Apply(plane_and_space);
BENCHMARK(indefinite_umfpack<true>)->Apply(plane_and_space);
BENCHMARK(indefinite_umfpack<false>)->Apply(plane_and_space);
BENCHMARK(indefinite_eigen)->Apply(plane_and_space);
// Ours gives up at the first direction of negative energy, for a direct solver to go on.
BENCHMARK(iterative<Enforced::weakly>)->Apply(plane_and_space);
BENCHMARK(iterative_eigen<Enforced::weakly>)->Apply(plane_and_space);

}  // namespace
}  // namespace rfm::benchmarks
