#pragma once

#include <memory>
#include <vector>

#include "core/field.hpp"
#include "core/field_source.hpp"

namespace rfm {

// What transformations of graphs build nodes with.

/// The operation of `f` applied to other arguments, as many as it has.
Field with_arguments(const Field& f, std::vector<Field> arguments);

/// (∂^α s)(place(x)): a sampled field, or a derivative of it with respect to its own coordinates,
/// at mapped points. `place` has as many components as the region of the source has dimensions,
/// else `InvalidArgument` is thrown. Bounds are known for |α| ≤ 1, from those of s over the range
/// of the place; where s is not smooth is known to quadrature under maps along the axes
/// (core/source_breakpoints.hpp).
Field field_at(std::shared_ptr<const FieldSource> source, std::vector<Field> place,
               const MultiIndex& alpha = {});

/// α of a node made by `field_at`.
MultiIndex source_derivative(int index);

}  // namespace rfm
