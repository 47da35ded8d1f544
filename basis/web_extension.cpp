#include "basis/web_extension.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "core/bspline.hpp"
#include "core/error.hpp"

namespace rfm {
namespace {

using Place = std::array<int, 3>;

// Calls f for all places from `low` to `high`, both included.
template <class Function>
void for_each_place(const Place& low, const Place& high, const Function& f) {
  for (int k = low[2]; k <= high[2]; ++k)
    for (int j = low[1]; j <= high[1]; ++j)
      for (int i = low[0]; i <= high[0]; ++i) f(Place{i, j, k});
}

class Arrays {
 public:
  Arrays(const TensorProductSpace& space, const std::vector<bool>& is_inner) : space_(space) {
    for (int axis = 0; axis < 3; ++axis)
      span_[axis] = axis < space.dimension() ? space.degree() : 0;
    complete_.assign(space.spline_count(), false);
    for (int spline = 0; spline < space.spline_count(); ++spline) {
      const Place low = space.place(spline);
      bool complete = true;
      for (int axis = 0; axis < 3; ++axis)
        complete = complete && low[axis] + span_[axis] < space.splines(axis);
      if (complete)
        for_each_place(low, high(low), [&](const Place& place) {
          complete = complete && is_inner[space.spline(place)];
        });
      complete_[spline] = complete;
    }
  }

  Place high(const Place& low) const {
    return {low[0] + span_[0], low[1] + span_[1], low[2] + span_[2]};
  }

  // The lowest place of the complete array whose middle is nearest.
  Place nearest(const Place& place) const {
    Place best{-1, -1, -1};
    int least = std::numeric_limits<int>::max();
    const int most = std::max({space_.splines(0), space_.splines(1), space_.splines(2)});
    for (int reach = 0; reach <= most; ++reach) {
      // Twice a distance from the middle, which is at least 2 reach − degree beyond this shell.
      const int beyond = 2 * reach - space_.degree();
      if (best[0] >= 0 && beyond > 0 && beyond * beyond > least) break;
      search(place, reach, best, least);
    }
    if (best[0] < 0)
      throw InvalidArgument(
          "the grid is too coarse to extend its splines: nowhere are degree + 1 of them inside the "
          "region along each axis");
    return best;
  }

 private:
  void search(const Place& place, int reach, Place& best, int& least) const {
    Place low{}, top{};
    for (int axis = 0; axis < space_.dimension(); ++axis) {
      low[axis] = std::max(0, place[axis] - reach);
      top[axis] = std::min(space_.splines(axis) - 1, place[axis] + reach);
    }
    for_each_place(low, top, [&](const Place& corner) {
      int shell = 0;
      for (int axis = 0; axis < space_.dimension(); ++axis)
        shell = std::max(shell, std::abs(corner[axis] - place[axis]));
      if (shell != reach || !complete_[space_.spline(corner)]) return;
      int distance = 0;  // squared, of twice the way to the middle
      for (int axis = 0; axis < space_.dimension(); ++axis) {
        const int way = 2 * (corner[axis] - place[axis]) + span_[axis];
        distance += way * way;
      }
      if (distance >= least) return;
      least = distance;
      best = corner;
    });
  }

  const TensorProductSpace& space_;
  Place span_{};
  std::vector<bool> complete_;
};

using Weights = std::array<double, maximum_spline_degree + 1>;

// Of splines low … low + degree along an axis, in the coefficient of spline `at` of the polynomial
// that they make of the cell `low`, where they all live.
Weights continued(const Grid& grid, int axis, int degree, int low, int at) {
  Weights weights{};
  if (grid.is_uniform()) {  // Lagrange's polynomials of the places
    for (int own = 0; own <= degree; ++own) {
      weights[own] = 1;
      for (int other = 0; other <= degree; ++other)
        if (other != own) weights[own] *= double(at - low - other) / (own - other);
    }
    return weights;
  }
  // The polynomial's blossom at the inner knots of the spline, by de Boor's algorithm.
  const auto knot = [&](int j) { return grid.knot(axis, low + 1 - degree + j); };
  std::array<Weights, maximum_spline_degree + 1> rows{};
  for (int i = 0; i <= degree; ++i) rows[i][i] = 1;
  for (int r = 1; r <= degree; ++r) {
    const double t = grid.knot(axis, at - degree + r);
    for (int i = degree; i >= r; --i) {
      const double before = knot(i - 1), behind = knot(i - r + degree);
      const double weight = (t - before) / (behind - before);
      for (int c = 0; c <= degree; ++c)
        rows[i][c] = (1 - weight) * rows[i - 1][c] + weight * rows[i][c];
    }
  }
  return rows[degree];
}

}  // namespace

WebExtension::WebExtension(const TensorProductSpace& space, std::span<const std::uint8_t> inside) {
  const Grid& grid = space.grid();
  if (inside.size() != std::size_t(grid.cell_count()))
    throw InvalidArgument("an extension takes a flag for every cell of the grid");
  std::vector<bool> is_inner(space.spline_count(), false);
  std::vector<int> functions(space.functions_per_cell());
  for (int cell = 0; cell < grid.cell_count(); ++cell) {
    if (inside[cell] == 0) continue;
    space.cell_functions(cell, functions);
    for (const int function : functions)
      if (function >= 0) is_inner[space.spline_of_function(function)] = true;
  }
  extend(space, is_inner);
}

WebExtension WebExtension::of_inner(const TensorProductSpace& space,
                                    const std::vector<bool>& inner) {
  if (inner.size() != std::size_t(space.size()))
    throw InvalidArgument("an extension takes a flag for every function");
  std::vector<bool> is_inner(space.spline_count(), false);
  for (int function = 0; function < space.size(); ++function)
    is_inner[space.spline_of_function(function)] = inner[function];
  WebExtension web;
  web.extend(space, is_inner);
  return web;
}

// By spline.
void WebExtension::extend(const TensorProductSpace& space, const std::vector<bool>& is_inner) {
  std::vector<int> number(space.spline_count(), -1);
  for (int function = 0; function < space.size(); ++function)
    if (is_inner[space.spline_of_function(function)]) {
      number[space.spline_of_function(function)] = size();
      inner_.push_back(function);
    }
  const Arrays arrays(space, is_inner);
  for (int function = 0; function < space.size(); ++function) {
    const int spline = space.spline_of_function(function);
    if (is_inner[spline]) {
      entries_.push_back({function, number[spline], 1});
      continue;
    }
    const Place place = space.place(spline), low = arrays.nearest(place);
    std::array<Weights, 3> along;
    for (int axis = 0; axis < space.dimension(); ++axis)
      along[axis] = continued(space.grid(), axis, space.degree(), low[axis], place[axis]);
    for_each_place(low, arrays.high(low), [&](const Place& own) {
      double weight = 1;
      for (int axis = 0; axis < space.dimension(); ++axis)
        weight *= along[axis][own[axis] - low[axis]];
      if (weight != 0) entries_.push_back({function, number[space.spline(own)], weight});
    });
  }
}

}  // namespace rfm
