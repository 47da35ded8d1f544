#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/region.hpp"
#include "core/thin_set.hpp"
#include "problems/boundary_conditions.hpp"
#include "problems/value_reader.hpp"
#include "solution_structures/set_interpolation.hpp"

namespace rfm {

/// Data of interpolation on a set, a shape or a side, as an entry of `conditions` or `interpolate`
/// gives them.
struct InterpolationDatum {
  std::string name;
  SetData data;
  /// Across this the interpolant is not smooth: the surface of a set.
  std::optional<Field> surface;
  /// Or this is its set: all of a shape.
  std::optional<Region> region;
  Place place;
};

/// What names stand for: sets; shapes, of which those that bound the domain are their boundary and
/// all others the whole of their points; sides.
struct InterpolationPlaces {
  const std::map<std::string, ThinSet>& sets;
  const std::map<std::string, Region>& shapes;
  const std::optional<Region>& domain;
  int dimension = 2;
};

/// Whether an entry's name is that of a shape that is no part of the boundary of the domain.
bool is_inner_shape(const std::string& name, const std::map<std::string, Region>& shapes,
                    const std::optional<Region>& domain);

/// Reports exponents that lose a derivative, and derivatives without those that they need; whether
/// there were none.
bool check_interpolation_entry(const DocumentNode& item, ValueReader& values);

/// Reports the keys of a file with `physics: {type: interpolation}` that only equations have.
void check_interpolation_file(const DocumentNode& root, ValueReader& values);

/// The entries of `conditions` on sets and on shapes inside the domain, of `physics: {type:
/// interpolation}`. Throws `ProblemFileErrors`.
std::vector<InterpolationDatum> inner_interpolation_data(const Problem& problem);

/// u as the interpolant of so many sets of data (solution_structures/set_interpolation.hpp).
struct Interpolation {
  Structure structure;
  int sets = 0;
};
/// That of all conditions. Throws `ProblemFileErrors`.
Interpolation interpolation(const Problem& problem, const std::vector<PieceCondition>& conditions,
                            const RegionEvaluator& region, const Box& bounds);

/// A coefficient `{interpolate: [{at: .., value: ..}, ..]}`: a material graded between sets. The
/// mistakes are reported; then nothing. `scope` is what its formulas may name.
std::optional<Field> interpolated_coefficient(const DocumentNode& list,
                                              const InterpolationPlaces& places,
                                              const std::optional<Box>& bounds,
                                              const ExpressionScope& scope, ValueReader& values);

}  // namespace rfm
