#pragma once

#include "problems/boundary_reader.hpp"
#include "problems/problem.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// The names of the unknowns of a document, `u` where the physics do not name them: known before
/// anything else is read, since formulas everywhere may use them.
std::vector<std::string> unknown_names(const DocumentNode& root, ValueReader& values);

/// Gives the names of the user's own coefficients, of `physics` (`map`) and its materials, their
/// meaning in formulas, chosen point by point. `of_materials[i]` is where `materials[i]` was read.
void define_own_coefficients(const DocumentNode& map, ValueReader& values,
                             const std::vector<Material>& materials,
                             const std::vector<const DocumentNode*>& of_materials,
                             const std::vector<std::string>& unknowns);

/// Reads the formulas of `physics: {type: custom}`; that of a mass becomes the coefficient `mass`.
CustomPhysics read_custom(const DocumentNode& map, ValueReader& values,
                          const std::vector<std::string>& unknowns,
                          std::map<std::string, PhysicalCoefficient>& coefficients);

/// Reads `physics.boundary` of custom physics, when parts of the boundary have names.
void read_custom_boundary(const DocumentNode& root, ValueReader& values, BoundaryReader& boundary,
                          Problem& problem);

}  // namespace rfm
