#pragma once

#include <array>
#include <span>

#include "core/interval.hpp"

namespace rfm {

/// What is known of the points of one evaluation: `count` ≤ `Tape::block_size` points, coordinate
/// by coordinate (those that no field of the tape uses may be null), and what a field may depend on
/// besides: the time, the parameters, and further coordinates, numbered from 4 on, again with
/// `count` values each.
struct PointBlock {
  std::array<const double*, 3> coordinates{};
  int count = 0;
  double time = 0;
  std::span<const double> parameters{};
  std::span<const double* const> further{};
};

/// What a field may depend on besides x, y, z, at a single point. A number is a time.
struct OtherValues {
  double time = 0;
  std::span<const double> parameters{};
  std::span<const double> further{};  ///< coordinates 4, 5, …

  OtherValues(double time = 0, std::span<const double> parameters = {},  // NOLINT: implicit
              std::span<const double> further = {})
      : time(time), parameters(parameters), further(further) {}
};

/// The same for bounds over a box: each may range over an interval. Of parameters that are not
/// given nothing is known.
struct OtherRanges {
  Interval time{};
  std::span<const Interval> parameters{};
  std::span<const Interval> further{};

  OtherRanges(Interval time = 0.0, std::span<const Interval> parameters = {},  // NOLINT: implicit
              std::span<const Interval> further = {})
      : time(time), parameters(parameters), further(further) {}
  OtherRanges(double time) : OtherRanges(Interval(time)) {}  // NOLINT: implicit
};

}  // namespace rfm
