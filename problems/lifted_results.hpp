#pragma once

#include "problems/document.hpp"

namespace rfm {

/// Results of other problems where conditions, shapes and coefficients of one's own want a formula,
/// {from: heat.yaml, field: u}, become entries of `fields:`, and their names (u_of_heat) the
/// formulas: whoever reads the document, or what is written of it, knows one form only. What is
/// asked for twice is one field. Coefficients of equations by name, which also take other maps, are
/// left as they are.
void lift_results(DocumentNode& root);

}  // namespace rfm
