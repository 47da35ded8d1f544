#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

#include "quadrature/compensated_sum.hpp"
#include "solvers/cell_kernel.hpp"
#include "solvers/cell_points.hpp"
#include "solvers/cell_tiles.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/stencil_matrix.hpp"

namespace rfm {

/// What assembly knows before the first point. Refers to spaces, rule and arguments.
struct AssemblyPlan {
  std::span<const TensorProductSpace> spaces;
  const FieldArguments& arguments;
  const DomainRule& rule;
  CellPointIndex index;
  std::vector<CompiledIntegrand> integrands;
  /// Basis functions at the points of any cell inside, per integrand.
  std::vector<BasisValues> inside_values;
  /// No contribution has couplings.
  bool symmetric = true;
  /// coupled[k · n + l]: undetermined functions k and l (k ≥ l if symmetric) interact.
  std::vector<bool> coupled;

  AssemblyPlan(std::span<const Structure> structures, std::span<const TensorProductSpace> spaces,
               std::span<const Contribution> contributions, const DomainRule& rule,
               const FieldArguments& arguments);
};

/// What assembly adds up: the matrix, the right-hand side, and the constant of every tile.
struct AssemblySums {
  StencilMatrix matrix;
  Eigen::VectorXd right_hand_side;
  std::vector<CompensatedSum> constants;
};

/// One integrand over one tile of cells, on one thread. Points are gathered over several cells, so
/// that coefficients are evaluated for many points at once; then each cell is done by dense
/// products and added to the sums.
class TileIntegrator {
 public:
  /// Refers to `plan`.
  TileIntegrator(const AssemblyPlan& plan, int integrand);

  void integrate(const CellTiles& tiles, int tile, AssemblySums& sums);

 private:
  // Points first … last − 1 of the batch are in `cell`, and may be those of any cell inside.
  struct Item {
    int cell = 0, first = 0, last = 0;
    bool tabulated = false;
  };
  void add_volume(int cell);
  void add_surface(int cell);
  template <class Append>
  void add_in_parts(int cell, PointRange range, Append&& append);
  void make_room(int points);
  void flush();
  void add_load(int cell);

  const AssemblyPlan& plan_;
  const Contribution& contribution_;
  const BasisValues& inside_values_;
  int capacity_;
  IntegrandValues values_;
  CellKernel kernel_;
  BasisValues basis_;
  IntegrandPoints points_;
  std::vector<Item> items_;
  std::vector<int> functions_;
  AssemblySums* sums_ = nullptr;
  int tile_ = 0;
};

}  // namespace rfm
