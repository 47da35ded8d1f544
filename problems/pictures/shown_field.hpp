#pragma once

#include "problems/output/colour_map.hpp"
#include "problems/scalar_problem.hpp"

namespace rfm {

/// What a picture shows.
struct ShownField {
  std::string title;  ///< of the picture
  std::string name;   ///< of the field: |flux| for a vector
  std::vector<Field> components;
  double size = 0;  ///< largest component at the quadrature points; 0 if one is not a number
  bool is_vector() const { return components.size() > 1; }
};

/// The title of a problem; without one, the name of its file.
std::string shown_title(const Problem& problem);

/// Gives the names in `picture.field` their meaning. Throws `ProblemFileErrors` if there is none.
ShownField shown_field(const Problem& problem, const ScalarSolution& solution,
                       const Picture& picture);

/// What the colours (or the axis, in 1D) span: as the file asks, else `data`, symmetric about zero
/// for diverging colours. Pixels miss the extremes on the boundary by a little: an end that is less
/// than half a percent short of a round number is extended to it.
/// Data that do not vary but for rounding, compared with themselves and with `size`, have one
/// value.
ValueRange shown_range(const Picture& picture, const ValueRange& data, double size = 0);

}  // namespace rfm
