#pragma once

namespace rfm {

struct LineSegment;

/// Knows the lines beside a line. Surfaces that meet a line in one place up to rounding are one
/// surface, or they touch or come near each other there, and then they are two boundaries: other
/// lines tell.
class LineNeighbours {
 public:
  virtual ~LineNeighbours() = default;
  /// By how much surface `first` is higher than `second` on the line, of those beside `line` up to
  /// where the two cross, on which they are farthest apart. Zero if nothing is known.
  virtual double height_over(int first, int second, const LineSegment& line) const = 0;
  /// Something with a length that rounding does not explain was left out as empty.
  virtual void note_loss() const = 0;
};

}  // namespace rfm
