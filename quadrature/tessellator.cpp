#include "quadrature/tessellator.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

double position_on(const ActiveSet& active, const LineEnd& end, const LineSegment& line,
                   bool is_low) {
  if (end.surface == LineEnd::segment_end) return is_low ? line.low : line.high;
  return find_crossing(*active.surfaces[end.surface], line).position;
}

double interpolated(double from, double to, int i, int count) {
  return i == count ? to : from + (to - from) * i / count;
}

int Tessellator::add_vertex(const Point& local) {
  Point vertex = frame_ ? frame_->to_world(local) : local;
  for (int axis = 0; axis < limits_.dimension; ++axis)
    vertex[axis] = std::clamp(vertex[axis], limits_.low[axis], limits_.high[axis]);
  out_.vertices.push_back(vertex);
  return static_cast<int>(out_.vertices.size()) - 1;
}

int Tessellator::steps(double length, int axis) const {
  constexpr double rounding = 1e-6;
  return std::max(1, static_cast<int>(std::ceil(length / spacing_[axis] - rounding)));
}

// A quadrilateral, or the triangle that is left when two neighbouring corners are one.
void Tessellator::add_element(std::array<int, 4> corners, bool reversed) {
  if (reversed) std::reverse(corners.begin(), corners.end());
  int count = 0;
  std::array<int, 4> distinct{};
  for (int i = 0; i < 4; ++i)
    if (corners[i] != corners[(i + 1) % 4]) distinct[count++] = corners[i];
  if (count < 3) return;
  out_.elements.add(count == 4 ? ElementShape::quadrilateral : ElementShape::triangle,
                    std::span(distinct).first(count));
}

void Tessellator::add_boundary(const ActiveSet& active, int surface, int first, int second) {
  if (active.is_interface(surface) || active.numbers[surface] == ActiveSet::no_piece) return;
  out_.boundary.add(ElementShape::segment, std::array{first, second});
  out_.primitives.push_back(active.numbers[surface]);
}

void Tessellator::full(const Box& box, const Frame* frame) {
  frame_ = frame;
  if (box.dimension == 1) return reduced(ActiveSet{}, {{}, 0, box.low[0], box.high[0]});
  if (box.dimension == 3) {
    Lattice lattice;
    for (int axis = 0; axis < 3; ++axis) lattice.cells[axis] = steps(box.length(axis), axis);
    const auto place = [&](int axis, int i) {
      return interpolated(box.low[axis], box.high[axis], i, lattice.cells[axis]);
    };
    for (int i = 0; i <= lattice.cells[0]; ++i)
      for (int j = 0; j <= lattice.cells[1]; ++j)
        for (int k = 0; k <= lattice.cells[2]; ++k)
          lattice.vertices.push_back(add_vertex({place(0, i), place(1, j), place(2, k)}));
    return add_lattice(lattice, true);
  }
  const int across = steps(box.length(0), 0), up = steps(box.length(1), 1);
  std::vector<int> below, above;
  for (int j = 0; j <= up; ++j, below.swap(above)) {
    above.clear();
    for (int i = 0; i <= across; ++i)
      above.push_back(add_vertex({interpolated(box.low[0], box.high[0], i, across),
                                  interpolated(box.low[1], box.high[1], j, up), 0}));
    for (int i = 0; j > 0 && i < across; ++i)
      add_element({below[i], below[i + 1], above[i + 1], above[i]}, false);
  }
}

void Tessellator::reduced(const ActiveSet& active, const LineSegment& line) {
  frame_ = nullptr;
  const LineRoots roots = find_line_roots(active, 0, line);
  walk_line(
      active, roots, line,
      [&](const LineEnd& from, const LineEnd& to) {
        const int count = steps(to.position - from.position, line.axis);
        int previous = add_vertex(line.at(from.position));
        for (int i = 1; i <= count; ++i) {
          const int next = add_vertex(line.at(interpolated(from.position, to.position, i, count)));
          out_.elements.add(ElementShape::segment, std::array{previous, next});
          previous = next;
        }
      },
      [](const LineCrossing&) {});
}

void Tessellator::reduced(const Reduction2D& reduction) {
  frame_ = reduction.frame();
  const auto& breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i].position, to = breakpoints[i + 1].position;
    if (to - from <= reduction.negligible_width()) continue;
    // The parts of lines are the same all the way between breakpoints.
    const LineSegment middle = reduction.line(0.5 * (from + to));
    const LineRoots roots = find_line_roots(reduction.active(), reduction.vertical(), middle);
    walk_line(
        reduction.active(), roots, middle,
        [&](const LineEnd& low, const LineEnd& high) {
          add_strip(reduction, {low, high}, from, to);
        },
        [&](const LineCrossing& side) { add_side(reduction, side, from, to); });
  }
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall);
}

void Tessellator::add_strip(const Reduction2D& reduction, const Strip& strip, double from,
                            double to) {
  const ActiveSet& active = reduction.active();
  const int columns = steps(to - from, reduction.base());
  std::vector<std::array<double, 2>> ends;
  double highest = 0;
  for (int i = 0; i <= columns; ++i) {
    const LineSegment line = reduction.line(interpolated(from, to, i, columns));
    const double low = position_on(active, strip.low, line, true);
    const double high = std::max(low, position_on(active, strip.high, line, false));
    ends.push_back({low, high});
    highest = std::max(highest, high - low);
  }
  const int layers = steps(highest, reduction.height());
  const bool reversed = reduction.base() != 0;
  const double same = same_vertex * reduction.plane().height_length();
  std::vector<int> left, right;
  for (int i = 0; i <= columns; ++i, left.swap(right)) {
    right.clear();
    const LineSegment line = reduction.line(interpolated(from, to, i, columns));
    const auto [low, high] = ends[i];
    for (int j = 0; j <= layers; ++j) {
      const bool is_new = j == 0 || high - low > same;
      right.push_back(is_new ? add_vertex(line.at(interpolated(low, high, j, layers)))
                             : right.back());
    }
    if (i == 0) continue;
    for (int j = 0; j < layers; ++j)
      add_element({left[j], right[j], right[j + 1], left[j + 1]}, reversed);
  }
}

// The boundary along a strip. It is followed even where the strip itself has no height, as at a
// face on the side of the box.
void Tessellator::add_side(const Reduction2D& reduction, const LineCrossing& side, double from,
                           double to) {
  const ActiveSet& active = reduction.active();
  if (side.interface || active.numbers[side.surface] == ActiveSet::no_piece) return;
  const int columns = steps(to - from, reduction.base());
  const bool forwards = side.begins == (reduction.base() == 0);
  const LineEnd end{side.position, side.surface};
  int previous = 0;
  for (int i = 0; i <= columns; ++i) {
    const LineSegment line = reduction.line(interpolated(from, to, i, columns));
    const int next = add_vertex(line.at(position_on(active, end, line, true)));
    if (i > 0)
      add_boundary(active, side.surface, forwards ? previous : next, forwards ? next : previous);
    previous = next;
  }
}

void Tessellator::add_wall(const Reduction2D& reduction, const Wall& wall) {
  const ActiveSet& active = reduction.active();
  const LineSegment line = reduction.line(wall.position);
  const LineRoots roots = find_line_roots(active, reduction.vertical(), line);
  walk_wall(
      active, roots, reduction.vertical(), line, wall.left, wall.right, [&](const WallPart& part) {
        const int count = steps(part.length(), reduction.height());
        // Upwards the lower base coordinates are on the left, if the base axis is the first.
        const bool positive_right = wall.right >> part.surface & 1;
        const bool inside_left = part.inside_is_positive != positive_right;
        const bool upwards = inside_left == (reduction.base() == 0);
        int previous = add_vertex(line.at(part.from.position));
        for (int i = 1; i <= count; ++i) {
          const int next =
              add_vertex(line.at(interpolated(part.from.position, part.to.position, i, count)));
          add_boundary(active, part.surface, upwards ? previous : next, upwards ? next : previous);
          previous = next;
        }
      });
}

}  // namespace rfm
