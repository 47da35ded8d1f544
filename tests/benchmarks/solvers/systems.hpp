#pragma once

#include "tests/solvers/sample_problems.hpp"

/// Systems of equations as problems give them, for benchmarks: −Δu = 1, u = 0 on a disk or ball.
namespace rfm::benchmarks {

struct Discretization {
  std::vector<Structure> structures;
  std::vector<TensorProductSpace> spaces;
  std::vector<Contribution> contributions;
  DomainRule rule;

  LinearSystem system() const { return assemble(structures, spaces, contributions, rule); }
};

inline Region unit_ball(int dimension) {
  return dimension == 2 ? circle({0, 0}, 1) : sphere({0, 0, 0}, 1);
}

inline Grid ball_grid(int dimension, int cells) {
  return Grid({dimension, {-1.03, -1.04, -1.02}, {1.05, 1.03, 1.06}},
              {cells, cells, dimension > 2 ? cells : 1});
}

/// u = ω Ψ: positive definite.
inline Discretization by_structure(int dimension, int degree, int cells) {
  const Region region = unit_ball(dimension);
  DomainRule rule = test::rule_for(region, ball_grid(dimension, cells), degree);
  const TensorProductSpace space(rule.grid(), degree, cells_in_region(rule));
  return {{region.primitives()[0]->function * Structure::undetermined()},
          {space},
          {{test::diffusion(dimension, 1.0, 0.0, 1.0)}},
          std::move(rule)};
}

/// By Nitsche's method with the penalty 20 p²/h: indefinite, through splines that a cut leaves
/// little of.
inline Discretization weakly(int dimension, int degree, int cells) {
  const Region region = unit_ball(dimension);
  DomainRule rule = test::rule_for(region, ball_grid(dimension, cells), degree);
  const TensorProductSpace space(rule.grid(), degree, cells_in_region(rule));
  QuadraticEnergy boundary;
  for (int axis = 0; axis < dimension; ++axis)
    boundary.add_stiffness(test::value(), test::slope(axis), -Coefficient::normal(axis));
  boundary.add_stiffness(test::value(), test::value(),
                         20.0 * degree * degree / rule.grid().spacing(0));
  return {{Structure::undetermined()},
          {space},
          {{test::diffusion(dimension, 1.0, 0.0, 1.0)}, {boundary, Contribution::Place::boundary}},
          std::move(rule)};
}

}  // namespace rfm::benchmarks
