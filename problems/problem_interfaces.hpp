#pragma once

#include "problems/problem.hpp"
#include "quadrature/interfaces.hpp"

namespace rfm {

/// Where quadrature splits cells, since integrands jump: at the boundaries of materials, at
/// curves and surfaces inside the domain that conditions are about, and at those of
/// parts of the domain that probes look at; rules of the boundary also where parts of it end that
/// conditions or probes name.
class ProblemInterfaces {
 public:
  explicit ProblemInterfaces(const Problem& problem);

  Interfaces all() const { return {levels_, ends_}; }

 private:
  void add_boundary_of(const Region& region);
  void add_ends(const BoundaryTarget& target, int dimension);

  std::vector<LevelFunction> levels_;
  std::vector<BoundaryEnds> ends_;
  std::vector<Field> functions_;  // those of the ends
};

}  // namespace rfm
