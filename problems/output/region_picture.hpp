#pragma once

#include <optional>
#include <string>

#include "problems/output/canvas.hpp"
#include "problems/output/colour_bar.hpp"
#include "problems/output/pixel_window.hpp"

namespace rfm {

/// A region of the plane with its boundary in pieces and the grid behind it.
struct RegionPicture {
  PixelWindow window;
  RegionPixels region;
  /// Parts of the region whose boundaries are shown as thin lines: materials.
  std::vector<RegionPixels> parts;
  /// A function of the region whose level lines are drawn, and |∇| times the side of a pixel.
  std::vector<double> omega, slope;
  double level_step = 0;
  /// Of each pixel: whether the grid cell that holds it is cut by the boundary.
  std::vector<char> in_cut_cell;
  /// Of each pixel near the boundary: its piece, −1 elsewhere.
  std::vector<int> piece;
  struct Piece {
    std::string name;         ///< written beside it
    std::string description;  ///< in the legend
    Colour colour;
  };
  std::vector<Piece> pieces;
  /// A point or a curve that need not bound anything.
  struct Set {
    Piece piece;
    std::vector<float> distance;  ///< of each pixel's centre from it, in pixels
    double width = 0;             ///< of its line
  };
  std::vector<Set> sets;
  /// Coordinates of the grid's lines across x and across y.
  std::vector<double> grid_x, grid_y;
};

struct RegionStyle {
  double font_size = 16;
  double boundary_width = 3.5;
};

/// Paints the region with its upper left corner at pixel (left, top): cells inside pale blue, the
/// inner parts of cut cells pale orange, grid lines (where they are four pixels apart or more),
/// level lines, pieces and sets in their colours. Names are written beside their pieces where they
/// hide no piece and no other name; the legend has them all.
void paint_region(Canvas& canvas, int left, int top, const RegionPicture& picture,
                  const RegionStyle& style);

/// Lists pieces beside their colours, as many as there is room for, with the names of the kinds of
/// cells below.
void draw_legend(Canvas& canvas, const PixelRectangle& room,
                 const std::vector<RegionPicture::Piece>& pieces, double font_size);
/// Pixels that the legend's longest line needs.
double legend_width(const std::vector<RegionPicture::Piece>& pieces, double font_size);

}  // namespace rfm
