#include <algorithm>

#include "quadrature/section_columns.hpp"
#include "quadrature/tessellator.hpp"

namespace rfm {
namespace {

using Breakpoint = Reduction2D::Breakpoint;

// Whether (outer, inner, height) is a right-handed order of the axes.
bool is_right_handed(const Reduction3D& reduction) {
  return (reduction.outer() + 1) % 3 == reduction.inner();
}

// Whether the inside is where coordinates across the wall are larger.
bool is_inside_right(const Wall& wall, const WallPart& part) {
  const bool positive_right = wall.right >> part.surface & 1;
  return part.inside_is_positive == positive_right;
}

}  // namespace

void Tessellator::reduced(Reduction3D& reduction) {
  frame_ = nullptr;
  const std::vector<double> breakpoints = reduction.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i], to = breakpoints[i + 1];
    if (to - from <= reduction.negligible_width()) continue;
    const SectionColumns sections(reduction, from, to, steps(to - from, reduction.outer()));
    for (std::size_t b = 0; b + 1 < sections.at_middle.size(); ++b)
      add_strip(reduction, sections, static_cast<int>(b));
    for (const auto& wall : sections.walls) add_wall(reduction, sections, wall);
  }
  for (const auto& wall : reduction.walls()) add_wall(reduction, wall);
}

// What lies between two neighbouring breakpoints of the sections.
void Tessellator::add_strip(Reduction3D& reduction, const SectionColumns& sections, int strip) {
  const double from = sections.at_middle[strip].position;
  const double to = sections.at_middle[strip + 1].position;
  const Reduction2D& middle = reduction.section(sections.middle);
  if (to - from <= middle.negligible_width()) return;
  const SurfaceSigns vertical = middle.vertical();
  const LineSegment line = middle.line(0.5 * (from + to));
  const LineRoots roots = find_line_roots(reduction.active(), vertical, line);
  walk_line(
      reduction.active(), roots, line,
      [&](const LineEnd& low, const LineEnd& high) {
        add_part(reduction, sections, strip, low, high);
      },
      [&](const LineCrossing& side) { add_side(reduction, sections, strip, side); });
}

void Tessellator::add_part(Reduction3D& reduction, const SectionColumns& sections, int strip,
                           const LineEnd& low, const LineEnd& high) {
  const int columns = static_cast<int>(sections.columns.size()) - 1;
  const int rows = steps(sections.widest(strip), reduction.inner());
  const auto line_at = [&](int column, int row) {
    LineSegment line;
    line.axis = reduction.height();
    line.low = reduction.box().low[line.axis];
    line.high = reduction.box().high[line.axis];
    line.through[reduction.outer()] = sections.columns[column];
    const auto& places = sections.positions[column];
    line.through[reduction.inner()] = interpolated(places[strip], places[strip + 1], row, rows);
    return line;
  };
  std::vector<std::array<double, 2>> ends;
  double highest = 0;
  for (int i = 0; i <= columns; ++i)
    for (int j = 0; j <= rows; ++j) {
      const LineSegment line = line_at(i, j);
      const double bottom = position_on(reduction.active(), low, line, true);
      const double top = std::max(bottom, position_on(reduction.active(), high, line, false));
      ends.push_back({bottom, top});
      highest = std::max(highest, top - bottom);
    }
  Lattice lattice;
  lattice.cells = {columns, rows, steps(highest, reduction.height())};
  lattice.vertices.resize((columns + 1) * (rows + 1) * (lattice.cells[2] + 1));
  const double same_place = same_vertex * reduction.box().length(reduction.inner());
  const double same_height = same_vertex * reduction.box().length(reduction.height());
  for (int i = 0; i <= columns; ++i) {
    const auto& places = sections.positions[i];
    const bool is_narrow = places[strip + 1] - places[strip] <= same_place;
    for (int j = 0; j <= rows; ++j) {
      const auto [bottom, top] = ends[i * (rows + 1) + j];
      for (int k = 0; k <= lattice.cells[2]; ++k) {
        int& vertex = lattice.at(i, j, k);
        if (is_narrow && j > 0)
          vertex = lattice.at(i, 0, k);
        else if (k > 0 && top - bottom <= same_height)
          vertex = lattice.at(i, j, 0);
        else
          vertex = add_vertex(line_at(i, j).at(interpolated(bottom, top, k, lattice.cells[2])));
      }
    }
  }
  add_lattice(lattice, is_right_handed(reduction));
}

// Hexahedra, or the tetrahedra that are left where corners coincide: those of Kuhn's division of
// the cube, one for each order in which the axes can be walked from one corner to the opposite one.
void Tessellator::add_lattice(Lattice& lattice, bool right_handed) {
  constexpr std::array<std::array<int, 3>, 6> orders = {
      {{0, 1, 2}, {1, 2, 0}, {2, 0, 1}, {0, 2, 1}, {2, 1, 0}, {1, 0, 2}}};
  for (int i = 0; i < lattice.cells[0]; ++i)
    for (int j = 0; j < lattice.cells[1]; ++j)
      for (int k = 0; k < lattice.cells[2]; ++k) {
        const auto corner = [&](int a, int b, int c) { return lattice.at(i + a, j + b, k + c); };
        std::array<int, 8> corners{corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0),
                                   corner(0, 1, 0), corner(0, 0, 1), corner(1, 0, 1),
                                   corner(1, 1, 1), corner(0, 1, 1)};
        auto sorted = corners;
        std::ranges::sort(sorted);
        if (std::ranges::adjacent_find(sorted) == sorted.end()) {
          if (!right_handed) {
            std::swap(corners[1], corners[3]);
            std::swap(corners[5], corners[7]);
          }
          out_.elements.add(ElementShape::hexahedron, corners);
          continue;
        }
        for (std::size_t o = 0; o < orders.size(); ++o) {
          std::array<int, 3> at{};
          std::array<int, 4> tetrahedron{corner(0, 0, 0)};
          for (int step = 0; step < 3; ++step) {
            at[orders[o][step]] = 1;
            tetrahedron[step + 1] = corner(at[0], at[1], at[2]);
          }
          if ((o < 3) != right_handed) std::swap(tetrahedron[1], tetrahedron[2]);
          auto distinct = tetrahedron;
          std::ranges::sort(distinct);
          if (std::ranges::adjacent_find(distinct) == distinct.end())
            out_.elements.add(ElementShape::tetrahedron, tetrahedron);
        }
      }
}

// Triangles of a sheet of vertices, counter-clockwise in (first index, second index).
void Tessellator::add_sheet(const ActiveSet& active, int surface,
                            const std::vector<std::vector<int>>& sheet, bool reversed) {
  if (active.is_interface(surface) || active.numbers[surface] == ActiveSet::no_piece) return;
  const auto add = [&](int a, int b, int c) {
    if (a == b || b == c || c == a) return;
    out_.boundary.add(ElementShape::triangle, reversed ? std::array{a, c, b} : std::array{a, b, c});
    out_.primitives.push_back(active.numbers[surface]);
  };
  for (std::size_t i = 0; i + 1 < sheet.size(); ++i)
    for (std::size_t j = 0; j + 1 < sheet[i].size(); ++j) {
      add(sheet[i][j], sheet[i + 1][j], sheet[i + 1][j + 1]);
      add(sheet[i][j], sheet[i + 1][j + 1], sheet[i][j + 1]);
    }
}

// Vertices between two ends on each of some lines of the height direction: lines by layers.
std::vector<std::vector<int>> Tessellator::sheet_between(const ActiveSet& active,
                                                         const std::vector<LineSegment>& lines,
                                                         const LineEnd& low, const LineEnd& high) {
  std::vector<std::array<double, 2>> ends;
  double highest = 0;
  for (const LineSegment& line : lines) {
    const double bottom = position_on(active, low, line, true);
    ends.push_back({bottom, std::max(bottom, position_on(active, high, line, false))});
    highest = std::max(highest, ends.back()[1] - bottom);
  }
  const int layers = steps(highest, lines.front().axis);
  std::vector<std::vector<int>> sheet(lines.size());
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const auto [bottom, top] = ends[i];
    const bool is_point = top - bottom <= same_vertex * (lines[i].high - lines[i].low);
    for (int k = 0; k <= layers; ++k)
      sheet[i].push_back(k > 0 && is_point
                             ? sheet[i].front()
                             : add_vertex(lines[i].at(interpolated(bottom, top, k, layers))));
  }
  return sheet;
}

// A surface above or below a strip: columns by rows.
void Tessellator::add_side(Reduction3D& reduction, const SectionColumns& sections, int strip,
                           const LineCrossing& side) {
  const int rows = steps(sections.widest(strip), reduction.inner());
  const double same_place = same_vertex * reduction.box().length(reduction.inner());
  std::vector<std::vector<int>> sheet;
  for (std::size_t i = 0; i < sections.columns.size(); ++i) {
    const double from = sections.positions[i][strip], to = sections.positions[i][strip + 1];
    auto& row = sheet.emplace_back();
    for (int j = 0; j <= rows; ++j) {
      if (j > 0 && to - from <= same_place) {
        row.push_back(row.front());
        continue;
      }
      LineSegment line{{},
                       reduction.height(),
                       reduction.box().low[reduction.height()],
                       reduction.box().high[reduction.height()]};
      line.through[reduction.outer()] = sections.columns[i];
      line.through[reduction.inner()] = interpolated(from, to, j, rows);
      row.push_back(add_vertex(
          line.at(position_on(reduction.active(), {side.position, side.surface}, line, true))));
    }
  }
  // Counter-clockwise in (outer, inner) is seen from above where the axes are right-handed; outside
  // is below where the region begins.
  add_sheet(reduction.active(), side.surface, sheet, side.begins == is_right_handed(reduction));
}

// A surface parallel to the height over a curve of the base plane: columns by layers.
void Tessellator::add_wall(Reduction3D& reduction, const SectionColumns& sections,
                           const Wall& wall) {
  const ActiveSet& active = reduction.active();
  const auto place = std::ranges::find(sections.at_middle, wall.position, &Breakpoint::position);
  if (place == sections.at_middle.end()) return;
  const std::size_t index = static_cast<std::size_t>(place - sections.at_middle.begin());
  const Reduction2D& middle = reduction.section(sections.middle);
  const LineSegment middle_line = middle.line(wall.position);
  const LineRoots roots = find_line_roots(active, middle.vertical(), middle_line);
  std::vector<LineSegment> lines(sections.columns.size(), middle_line);
  for (std::size_t i = 0; i < lines.size(); ++i) {
    lines[i].through[reduction.outer()] = sections.columns[i];
    lines[i].through[reduction.inner()] = sections.positions[i][index];
  }
  // Counter-clockwise in (outer, height) is seen from the low inner side where the axes are
  // right-handed.
  walk_wall(active, roots, middle.vertical(), middle_line, wall.left, wall.right,
            [&](const WallPart& part) {
              add_sheet(active, part.surface, sheet_between(active, lines, part.from, part.to),
                        is_inside_right(wall, part) != is_right_handed(reduction));
            });
}

// A surface across the outer axis: rows by layers in the section.
void Tessellator::add_wall(Reduction3D& reduction, const Wall& wall) {
  const ActiveSet& active = reduction.active();
  const Reduction2D& section = reduction.section(wall.position);
  const auto& breakpoints = section.breakpoints();
  for (std::size_t i = 0; i + 1 < breakpoints.size(); ++i) {
    const double from = breakpoints[i].position, to = breakpoints[i + 1].position;
    if (to - from <= section.negligible_width()) continue;
    const LineSegment middle = section.line(0.5 * (from + to));
    const LineRoots roots = find_line_roots(active, section.vertical(), middle);
    const int rows = steps(to - from, reduction.inner());
    std::vector<LineSegment> lines;
    for (int j = 0; j <= rows; ++j) lines.push_back(section.line(interpolated(from, to, j, rows)));
    // Counter-clockwise in (inner, height) is seen from the high outer side.
    walk_wall(active, roots, reduction.outer_only(), middle, wall.left, wall.right,
              [&](const WallPart& part) {
                add_sheet(active, part.surface, sheet_between(active, lines, part.from, part.to),
                          is_inside_right(wall, part) == is_right_handed(reduction));
              });
  }
}

}  // namespace rfm
