#pragma once

#include <ostream>

#include "tests/quadrature/regions.hpp"

/// The bodies by which rules are compared from version to version and with other programs.
namespace rfm::test {

struct StandardRegion {
  const char* name;
  Region region;
  Box box;
  /// Area and perimeter (volume and surface); NaN where no closed form is known.
  double measure = std::nan("");
  double boundary = std::nan("");
};

inline std::ostream& operator<<(std::ostream& out, const StandardRegion& body) {
  return out << body.name;
}

inline Region solid(const Field& level) { return region_of(level, 3); }

inline Box cube_box(double half, int dimension) { return grid(half, 1, dimension).box(); }

/// Rows of a rotation of space by three angles.
inline std::array<Point, 3> standard_rotation() {
  const double c = std::cos(0.3), s = std::sin(0.3), d = std::cos(0.5), e = std::sin(0.5);
  const double f = std::cos(0.7), g = std::sin(0.7);
  const Point u{c * d, s * d, e}, v{-s, c, 0}, w{-c * e, -s * e, d};
  std::array<Point, 3> rows{u, {}, {}};
  for (int i = 0; i < 3; ++i) {
    rows[1][i] = f * v[i] + g * w[i];
    rows[2][i] = -g * v[i] + f * w[i];
  }
  return rows;
}

/// The cube of half side `half`, turned.
inline Region rotated_cube(double half) {
  const auto rows = standard_rotation();
  const auto along = [&](int i) { return rows[i][0] * x() + rows[i][1] * y() + rows[i][2] * z(); };
  Region cube = solid(half - along(0)) & solid(half + along(0));
  for (int i = 1; i < 3; ++i) cube = cube & solid(half - along(i)) & solid(half + along(i));
  return cube;
}

inline std::vector<StandardRegion> standard_regions_2d() {
  const Box box = cube_box(1.7, 2);
  const Region sector =
      (((half_plane(-1, 1, 0) & half_plane(1, 1, 0)) | region_of(square(x()) - 1, 2)) &
       (half_plane(-1, 1, 0) | half_plane(1, 1, 0))) &
      region_of(9 - square(x()) - square(y()), 2);
  const Region flag = half_plane(1, 0, 1) & half_plane(-1, 0, 1.2) &
                      region_of(y() + 0.6 - 0.2 * sin(3 * x()), 2) &
                      region_of(0.7 - y() + 0.2 * sin(3 * x()), 2);
  return {{"disk", disk(0.1, -0.07, 1), box, pi, 2 * pi},
          {"ellipse", region_of(1 - square(x() - 0.03) - 4 * square(y() + 0.05), 2), box, pi / 2,
           4.84422411027383809921},
          {"disk-disk", disk(0, 0, 1) - disk(0.6, 0.3, 0.7), box},
          {"square", turned_square(0.9, 0.3), box, 3.24, 7.2},
          {"star", star(0.45, 0.21), box, star_area(0.45), star_perimeter(0.45)},
          {"sector", sector, cube_box(3.4, 2)},
          {"flag", flag, box}};
}

inline std::vector<StandardRegion> standard_regions_3d() {
  const Box box = cube_box(1.7, 3);
  const Field ring = square(x()) + square(y());
  const double volume = 0.32 * pi * pi, area = 1.6 * pi * pi;
  const Region cube = solid(1 - square(x())) & solid(1 - square(y())) & solid(1 - square(z()));
  Box board;
  board.dimension = 3;
  board.low = {-4.1, -4.1, -0.25};
  board.high = {4.1, 4.1, 8.25};
  const Region pawn =
      (solid(0.4375 * square(sqrt(ring) - 4) - z()) & solid(9 - ring) & solid(z() * (7 - z()))) |
      solid(1 - ring - square(7 - z())) | solid(2 - ring - 9 * square(6 - z()));
  const auto wave = [](const Field& a, const Field& b) { return sin(2.5 * a) * cos(2.5 * b); };
  const Region gyroid = solid(0.1 + wave(x(), y()) + wave(y(), z()) + wave(z(), x())) &
                        solid(2.25 - ring - square(z()));
  return {{"ball", solid(1 - square(x() - 0.1) - square(y() + 0.07) - square(z() - 0.03)), box,
           4 * pi / 3, 4 * pi},
          {"torus", solid(0.16 - square(sqrt(ring) - 1) - square(z() - 0.02)), box, volume, area},
          {"quartic torus", solid(4 * ring - square(ring + square(z() - 0.02) + 0.84)), box, volume,
           area},
          {"cube-ball", cube & solid(ring + square(z()) - 1.44), box},
          {"rotated cube", rotated_cube(0.85), box, 4.913, 17.34},
          {"pawn", pawn, board},
          {"gyroid", gyroid, box}};
}

}  // namespace rfm::test
