#pragma once

#include <functional>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// f(μ(x)): coordinate i of `f` replaced by `map[i]`; coordinates beyond the map stay themselves.
/// Derivatives of the result are exact. A partial derivative *within* `f` is one with respect to
/// the inner coordinate, and is taken before the map is put in: it becomes an expression
/// (core/graph_derivative.hpp), so that
///
///     compose(partial(f, 0), map)        is (∂f/∂x)(μ(x)), and
///     partial(compose(f, map), 0)        is ∂/∂x of f(μ(x)).
///
/// A sampled field is evaluated at the mapped points, its jets composed by the chain rule, outside
/// its region NaN as ever. Nodes that the map does not touch are shared. Graphs may be arbitrarily
/// deep.
Field compose(const Field& f, const std::vector<Field>& map);

/// `f` with another field in the place of every leaf: of each constant, coordinate, parameter and
/// sampled field. A partial derivative within `f` stays one, of the field with other leaves.
Field with_leaves(const Field& f, const std::function<Field(const Field&)>& leaf);

/// The same function with every partial derivative written out as an expression.
Field without_partials(const Field& f);

/// The normalizer f*(x) = f(x − ω∇ω) of Shapiro (2007), (7.2): where ω is normalised to first
/// order, f* = f on ω = 0 and has no normal derivative there.
Field normalizer(const Field& f, const Field& omega, int dimension);

}  // namespace rfm
