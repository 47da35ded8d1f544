#pragma once

#include <span>

#include "basis/tensor_product_space.hpp"
#include "quadrature/domain_rule.hpp"
#include "solvers/extraction.hpp"

namespace rfm {

/// Extended splines (basis/web_extension.hpp) of several spaces on the grid of a rule: the inner
/// ones, to which the others are attached.
struct SplineExtension : SplineExtraction {
  SplineExtension(std::span<const TensorProductSpace> spaces, const DomainRule& rule);
};

}  // namespace rfm
