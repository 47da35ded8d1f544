#pragma once

#include <vector>

#include "problems/output/image.hpp"

namespace rfm {

enum class ColourMap {
  /// Viridis (S. van der Walt and N. Smith, 2015, CC0): dark violet, blue, green, yellow. Equal
  /// steps
  /// of the value look equally large, lightness grows steadily (so that a grey copy still reads),
  /// and it survives the common kinds of colour blindness.
  uniform,
  /// Blue, near-white, red, symmetric in lightness: for signed values, zero in the middle.
  diverging
};

/// The colour at position `t` of a map, 0 to 1; beyond it the ends. Control colours are joined in
/// Oklab (B. Ottosson, 2020), in which distances are those that are seen.
Colour colour_at(ColourMap map, double t);

/// Lightness L of Oklab, 0 (black) to 1 (white).
double lightness(const Colour& colour);

/// Values and their colours: a map laid over [low, high].
class ColourScale {
 public:
  /// A range that is empty is widened around its value; low > high or a bound that is not finite
  /// throws `InvalidArgument`.
  ColourScale(ColourMap map, double low, double high);

  ColourMap map() const { return map_; }
  double low() const { return low_; }
  double high() const { return high_; }
  /// Values beyond the range get the colours of its ends, NaN grey.
  Colour operator()(double value) const;

 private:
  ColourMap map_;
  double low_, high_;
  std::vector<Colour> table_;
};

/// [low, high] made symmetric around zero: what a diverging map is laid over.
struct ValueRange {
  double low = 0, high = 1;
};
ValueRange symmetric_about_zero(const ValueRange& range);

}  // namespace rfm
