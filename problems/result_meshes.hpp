#pragma once

#include "problems/output/field_mesh.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// A solved problem as meshes for ParaView.
struct ResultMeshes {
  /// The domain, cut to its boundary.
  FieldMesh volume;
  /// The facets of the boundary, empty in 1D: the same results, the outward unit `normal`, the
  /// number of the `piece` (that of its primitive), and `flux.n`. Each piece has points of its own.
  FieldMesh boundary;
};

/// Samples u, its gradient, what the file asks for, and omega, at the resolution that it asks for.
/// Throws `ComputationError` where a result is not a finite number.
ResultMeshes result_meshes(const ScalarProblem& problem, const Grid& grid,
                           const ScalarSolution& solution);

}  // namespace rfm
