#include "solvers/refined_splines.hpp"

#include <algorithm>
#include <array>

#include "core/bspline.hpp"
#include "core/error.hpp"

namespace rfm {
namespace {

// A spline of the common grid along an axis in those of another: the splines `first` and following.
struct Row {
  int first = -1;  // none: beyond the box
  std::array<double, maximum_spline_degree + 1> weights{};
};

void require_lines(const Grid& own, const Grid& common, int axis) {
  for (int i = 0; i <= own.cells(axis); ++i) {
    const double line = own.line(axis, i);
    const int cell = common.locate(axis, line);
    if (common.line(axis, cell) != line && common.line(axis, cell + 1) != line)
      throw InvalidArgument("a common grid has all lines of the grids that share it");
  }
}

// The blossoms of the splines on cell `cell` at the inner knots of a common spline.
Row blossoms(const Grid& own, int cell, const Grid& common, int axis, int degree, int spline) {
  Row row;
  row.first = cell;
  row.weights[0] = 1;
  for (int q = 1; q <= degree; ++q) {
    const double x = common.knot(axis, spline - degree + q);
    double saved = 0;
    for (int r = 0; r < q; ++r) {
      const double left = own.knot(axis, cell + 1 - q + r), right = own.knot(axis, cell + r + 1);
      const double part = row.weights[r] / (right - left);
      row.weights[r] = saved + (right - x) * part;
      saved = (x - left) * part;
    }
    row.weights[q] = saved;
  }
  return row;
}

std::vector<Row> rows(const Grid& own, const Grid& common, int axis, int degree) {
  require_lines(own, common, axis);
  std::vector<Row> result(common.cells(axis) + degree);
  // The cells of the common grid that lie in the box of the own one.
  const auto is_in = [&](int cell) {
    return common.line(axis, cell) >= own.box().low[axis] &&
           common.line(axis, cell + 1) <= own.box().high[axis];
  };
  for (int spline = 0; spline < static_cast<int>(result.size()); ++spline) {
    int first = std::max(spline - degree, 0), last = std::min(spline, common.cells(axis) - 1);
    while (first <= last && !is_in(first)) ++first;
    while (first <= last && !is_in(last)) --last;
    if (first > last) continue;
    const int middle = (first + last) / 2;
    const double inside = 0.5 * (common.line(axis, middle) + common.line(axis, middle + 1));
    result[spline] = blossoms(own, own.locate(axis, inside), common, axis, degree, spline);
  }
  return result;
}

}  // namespace

SplineExtraction refined_splines(std::span<const TensorProductSpace> own,
                                 std::span<const TensorProductSpace> common) {
  if (own.size() != common.size())
    throw InvalidArgument("every function has a space of its own and a common one");
  SplineExtraction result;
  std::vector<Eigen::Triplet<double, std::int64_t>> entries;
  Eigen::Index row = 0, column = 0;
  for (std::size_t k = 0; k < own.size(); ++k) {
    const TensorProductSpace &coarse = own[k], &fine = common[k];
    const int degree = coarse.degree(), dimension = coarse.dimension();
    if (fine.degree() != degree || fine.dimension() != dimension)
      throw InvalidArgument("a function has one degree in its own grid and in the common one");
    std::array<std::vector<Row>, 3> axes;
    for (int axis = 0; axis < dimension; ++axis)
      axes[axis] = rows(coarse.grid(), fine.grid(), axis, degree);
    for (int axis = dimension; axis < 3; ++axis) axes[axis] = {Row{0, {1}}};
    std::array<int, 3> width{1, 1, 1};
    for (int axis = 0; axis < dimension; ++axis) width[axis] = degree + 1;
    for (int function = 0; function < fine.size(); ++function, ++row) {
      const std::array<int, 3> place = fine.place(fine.spline_of_function(function));
      const Row &x = axes[0][place[0]], &y = axes[1][place[1]], &z = axes[2][place[2]];
      if (x.first < 0 || y.first < 0 || z.first < 0) continue;
      for (int c = 0; c < width[2]; ++c)
        for (int b = 0; b < width[1]; ++b)
          for (int a = 0; a < width[0]; ++a) {
            const double weight = x.weights[a] * y.weights[b] * z.weights[c];
            const int number =
                coarse.function_of_spline(coarse.spline({x.first + a, y.first + b, z.first + c}));
            if (weight != 0 && number >= 0) entries.emplace_back(row, column + number, weight);
          }
    }
    column += coarse.size();
    result.first.push_back(column);
  }
  result.matrix.resize(row, column);
  result.matrix.setFromTriplets(entries.begin(), entries.end());
  return result;
}

}  // namespace rfm
