#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// The cells, among those flagged in `cells`, where undetermined function `function` matters to the
/// structures: where one of its factors is more than 10⁻⁶ of its largest absolute value at points
/// of `rule` in the domain. Elsewhere splines for it would be unknowns almost without equations.
/// All of `cells` where no factor differs from 0.
std::vector<std::uint8_t> cells_of_function(int function, std::span<const Structure> structures,
                                            const DomainRule& rule,
                                            std::vector<std::uint8_t> cells);

}  // namespace rfm
