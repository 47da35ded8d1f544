#pragma once

#include <optional>
#include <vector>

#include "problems/output/canvas.hpp"
#include "problems/output/colour_bar.hpp"

namespace rfm {

/// Finds places for names beside the curves that they name. An image is divided into coarse
/// squares; each knows which curves pass it, and whether it is taken.
class LabelPlaces {
 public:
  LabelPlaces(int width, int height);

  /// Curve `curve` passes pixel (x, y).
  void add_curve_pixel(int curve, int x, int y);
  /// The pixel is painted: names are written here only where nothing better is found.
  void add_painted_pixel(int x, int y);

  /// The upper left corner for a text of this size beside a curve, clear of all curves and of texts
  /// placed before, nearer to this curve than to others; or nothing. Takes the place.
  std::optional<PixelPosition> place(int curve, const TextExtent& text);

 private:
  struct Square {
    std::vector<int> curves;
    int painted_pixels = 0;
    bool is_taken = false;
  };
  double penalty(int curve, const PixelRectangle& text) const;
  int square_of(double x, double y) const;

  static constexpr int side = 4;
  int width_, height_, columns_, rows_;
  std::vector<Square> squares_;
  std::vector<std::vector<PixelPosition>> curves_;
};

}  // namespace rfm
