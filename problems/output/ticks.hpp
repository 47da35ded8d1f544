#pragma once

#include <string>
#include <vector>

namespace rfm {

/// Round numbers along an axis: neighbouring multiples of 1, 2 or 5 · 10ᵏ within [low, high].
struct Ticks {
  double step = 1;
  std::vector<double> values;
  /// As short as tells them apart; all with the same number of digits after the point, and with one
  /// common power of ten where they are very large or very small (2.5e-7; zero is 0).
  std::vector<std::string> labels;
};

/// About `count` ticks: their step is within a factor √2.5 of (high − low) / count. The first is
/// less than a step above `low`, the last less than a step below `high`. Throws `InvalidArgument`
/// unless low < high are finite and count is positive.
Ticks nice_ticks(double low, double high, int count);

/// Powers of ten 10ᵏ within [low, high], 0 < low < high, labelled 0.1, 1, 10, 1e5; where there are
/// fewer than two of them, also 2 and 5 times these.
Ticks decade_ticks(double low, double high);

}  // namespace rfm
