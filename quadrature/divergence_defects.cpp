#include "quadrature/divergence_defects.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {
namespace {

constexpr int most_corners = 8;
// Of a cell, by corner: bit a of its number says that it is the upper one along axis a.
using CornerVectors = std::array<Point, most_corners>;
// Σ w Π t_a over the axes a in a set, by the bits of the set; t = 0 … 1 across the cell.
using Moments = std::array<double, most_corners>;

class Defects {
 public:
  explicit Defects(const DomainRule& rule)
      : rule_(rule),
        grid_(rule.grid()),
        dimension_(rule.dimension()),
        corners_(1 << rule.dimension()) {
    node_strides_ = {1, grid_.cells(0) + 1, 0};
    if (dimension_ > 1)
      node_strides_[2] = static_cast<std::int64_t>(grid_.cells(0) + 1) * (grid_.cells(1) + 1);
    for (const CellReport& cell : rule.report().cells)
      for (int corner = 0; corner < corners_; ++corner) nodes_.push_back(node(cell.cell, corner));
    std::ranges::sort(nodes_);
    nodes_.erase(std::unique(nodes_.begin(), nodes_.end()), nodes_.end());
    vectors_.resize(nodes_.size());
  }

  std::vector<double> run() {
    add_inside_cells();
    for (std::size_t i = 0; i < rule_.cut_cells().size(); ++i)
      add_cut_cell(rule_.cut_cells()[i], rule_.cut_range(static_cast<int>(i)));
    hints_ = {};
    for (std::size_t i = 0; i < rule_.boundary().cells.size(); ++i)
      add_boundary(rule_.boundary().cells[i], rule_.boundary().range(static_cast<int>(i)));
    hints_ = {};
    std::vector<double> result;
    for (const CellReport& cell : rule_.report().cells) {
      const std::array<int, 3> position = grid_.position(cell.cell);
      double largest = 0;
      for (int corner = 0; corner < corners_; ++corner) {
        double defect = 0;
        const Point& vector = *find(cell.cell, corner);
        for (int axis = 0; axis < dimension_; ++axis)
          defect += std::fabs(vector[axis]) * grid_.width(axis, position[axis]) / dimension_;
        largest = std::max(largest, defect);
      }
      result.push_back(largest);
    }
    return result;
  }

 private:
  std::int64_t node(int cell, int corner) const {
    const std::array<int, 3> position = grid_.position(cell);
    std::int64_t number = 0;
    for (int axis = 0; axis < dimension_; ++axis)
      number += (position[axis] + (corner >> axis & 1)) * node_strides_[axis];
    return number;
  }

  // Cells are asked for in ascending order, so that the node of a corner ascends, too.
  Point* find(int cell, int corner) {
    const std::int64_t wanted = node(cell, corner);
    std::size_t& hint = hints_[corner];
    while (hint < nodes_.size() && nodes_[hint] < wanted) ++hint;
    return hint < nodes_.size() && nodes_[hint] == wanted ? &vectors_[hint] : nullptr;
  }

  // The cells inside around the nodes: ∫ ∂φ/∂x_a is ± the area of the side across a, by 2^(d−1).
  void add_inside_cells() {
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      std::array<int, 3> node{};
      std::int64_t rest = nodes_[i];
      for (int axis = dimension_ - 1; axis >= 0; --axis) {
        node[axis] = static_cast<int>(rest / node_strides_[axis]);
        rest %= node_strides_[axis];
      }
      for (int corner = 0; corner < corners_; ++corner) add_inside_cell(node, corner, vectors_[i]);
    }
  }

  // The cell of which `node` is the given corner.
  void add_inside_cell(const std::array<int, 3>& node, int corner, Point& vector) const {
    std::array<int, 3> position = node;
    for (int axis = 0; axis < dimension_; ++axis) {
      position[axis] -= corner >> axis & 1;
      if (position[axis] < 0 || position[axis] >= grid_.cells(axis)) return;
    }
    const int cell = grid_.number(position);
    if (rule_.state(cell) != CellState::inside) return;
    const double measure = grid_.cell_measure(cell);
    for (int axis = 0; axis < dimension_; ++axis)
      vector[axis] -= (corner >> axis & 1 ? 1 : -1) * measure / grid_.width(axis, position[axis]) *
                      std::ldexp(1.0, 1 - dimension_);
  }

  template <class Points>
  void add_moments(const Box& box, const Points& points, int i, double weight,
                   Moments& moments) const {
    Moments products{weight};
    for (int axis = 0; axis < dimension_; ++axis) {
      const double t = (points.coordinates[axis][i] - box.low[axis]) / box.length(axis);
      for (int set = 0; set < 1 << axis; ++set) products[set | 1 << axis] = products[set] * t;
    }
    for (int set = 0; set < corners_; ++set) moments[set] += products[set];
  }

  // From Σ w Π t to Σ w φ of the corners, but for the factor along `left_out`.
  Moments of_corners(const Moments& moments, int left_out) const {
    Moments result = moments;
    for (int axis = 0; axis < dimension_; ++axis)
      for (int set = 0; set < corners_; ++set) {
        const int bit = 1 << axis;
        if (set & bit) continue;
        if (axis == left_out)
          result[set | bit] = result[set];
        else
          result[set] -= result[set | bit];
      }
    return result;
  }

  void add_cut_cell(int cell, PointRange range) {
    const Box box = grid_.cell(grid_.position(cell));
    Moments moments{};
    for (int i = range.begin; i < range.end; ++i)
      add_moments(box, rule_.cut_points(), i, rule_.cut_points().weights[i], moments);
    CornerVectors vectors{};
    for (int axis = 0; axis < dimension_; ++axis) {
      const Moments sums = of_corners(moments, axis);
      for (int corner = 0; corner < corners_; ++corner)
        vectors[corner][axis] = (corner >> axis & 1 ? -1 : 1) * sums[corner] / box.length(axis);
    }
    add(cell, vectors);
  }

  void add_boundary(int cell, PointRange range) {
    const Box box = grid_.cell(grid_.position(cell));
    const SurfacePoints& points = rule_.boundary().points;
    CornerVectors vectors{};
    for (int axis = 0; axis < dimension_; ++axis) {
      Moments moments{};
      for (int i = range.begin; i < range.end; ++i)
        add_moments(box, points, i, points.weights[i] * points.normals[axis][i], moments);
      const Moments sums = of_corners(moments, -1);
      for (int corner = 0; corner < corners_; ++corner) vectors[corner][axis] = sums[corner];
    }
    add(cell, vectors);
  }

  void add(int cell, const CornerVectors& vectors) {
    for (int corner = 0; corner < corners_; ++corner)
      if (Point* vector = find(cell, corner))
        for (int axis = 0; axis < dimension_; ++axis) (*vector)[axis] += vectors[corner][axis];
  }

  const DomainRule& rule_;
  const Grid& grid_;
  int dimension_, corners_;
  std::array<std::int64_t, 3> node_strides_{};
  // Of the listed cells, ascending, and D there.
  std::vector<std::int64_t> nodes_;
  std::vector<Point> vectors_;
  std::array<std::size_t, most_corners> hints_{};
};

}  // namespace

std::vector<double> divergence_defects(const DomainRule& rule) { return Defects(rule).run(); }

}  // namespace rfm
