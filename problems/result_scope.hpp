#pragma once

#include <string>
#include <vector>

#include "core/expression.hpp"
#include "core/field.hpp"

namespace rfm {

/// The results of a problem as formulas name them.
struct ScalarResults {
  struct Unknown {
    std::string name;
    Field field;
  };
  std::vector<Unknown> unknowns;
  /// +k grad(u): `flux`, `flux.x`, …; empty for equations that have none.
  std::vector<Field> flux;
  int dimension = 2;
  /// Of an eigenproblem: `mode1`, …, by unknown. Of several unknowns u, v, … a mode is the vector
  /// of all, with the components `mode1.u`, …. The unknowns are the first.
  std::vector<std::vector<Field>> modes{};
};

/// Adds `n`, `n.x`, `n.y`, `n.z`: the outward unit normal of a boundary, one field per dimension.
void define_normal(ExpressionScope& scope, const std::vector<Field>& normal);
/// Adds the unknowns, `gradient`, `gradient.x`, … of a single one, `flux`, `flux.x`, … where there
/// is one; derivatives of them are `grad(u)`, `dx(u)`, …. What depends on the solution has no
/// derivative d(f, k) by a parameter here: the solution depends on k too, in a way that only
/// solving with another k shows.
void define_results(ExpressionScope& scope, const ScalarResults& results);
/// Adds `flux.n`, the flux along the outward normal, where there is a flux.
void define_boundary_results(ExpressionScope& scope, const ScalarResults& results,
                             const std::vector<Field>& normal);

/// Refuses the names of normals and of results, each with the reason.
void refuse_normal(ExpressionScope& scope, int dimension, const std::string& reason);
void refuse_results(ExpressionScope& scope, const ScalarResults& results,
                    const std::string& reason);

/// Stand-ins for checking a formula before there is a solution: they have the right number of
/// components, and any derivative of them exists.
ScalarResults stand_in_results(const std::vector<std::string>& unknowns, bool has_flux,
                               int dimension, int modes = 0);
std::vector<Field> stand_in_normal(int dimension);

/// The name of mode `number`, counted from 0: `mode1`.
std::string mode_name(std::size_t number);
/// Those of what is drawn of it: `mode1` alone if it is a number or a vector of the plane or space;
/// else, of unknowns of any meaning, `mode1.u`, ….
std::vector<std::string> mode_parts(const ScalarResults& results, std::size_t number);

/// The results that may be written to files: the unknowns, gradient, flux, modes and their
/// components.
std::vector<std::string> output_names(const ScalarResults& results);

}  // namespace rfm
