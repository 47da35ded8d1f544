#pragma once

#include <optional>
#include <span>
#include <vector>

#include "core/boolean.hpp"

namespace rfm {

/// A product of literals: `yes` for variable v, `no` for its negation, `unknown` where it does not
/// occur. As the signs of primitives at a point: `unknown` is zero.
using Cube = std::vector<Truth>;

/// A union of products, in the order given; false for none.
BooleanExpression sum_of_products(std::span<const Cube> cubes);

/// Whether a point with these signs lies in the closed set of a product: no literal is
/// contradicted.
bool covers(const Cube& product, const Cube& signs);
/// Whether it lies in its interior: no literal is contradicted or zero there.
bool covers_strictly(const Cube& product, const Cube& signs);

/// Products that together cover all of `on` strictly and none of `off` at all, as few and as short
/// as can be found; combinations of signs that neither names are don't-cares. With up to 8
/// variables all prime implicants are considered (Quine 1952, McCluskey 1956), beyond that those to
/// which the cubes of `on` expand in several orders; of them the smallest cover is searched for by
/// branch and bound, with an end: the result is irredundant (no product can be left out, none
/// shortened) and nearly always minimal. Empty where a cube of `on` cannot be covered without one
/// of `off`.
std::optional<std::vector<Cube>> minimal_cover(std::span<const Cube> on, std::span<const Cube> off);

/// A shortest expression for a truth table: row r holds the value where variable v is bit v of r,
/// `unknown` where it does not matter. A sum of products or a product of sums, whichever has fewer
/// literals. Throws `InvalidArgument` unless the table has 2ⁿ rows, n from 0 to 10.
BooleanExpression minimal_expression(std::span<const Truth> table);
/// The same for the function of an expression of up to 10 variables. Not for sets that touch
/// themselves: see `without_redundancy`.
BooleanExpression minimal_expression(const BooleanExpression& expression);

}  // namespace rfm
