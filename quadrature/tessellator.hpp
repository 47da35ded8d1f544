#pragma once

#include "quadrature/tessellation.hpp"

namespace rfm {

/// Turns the parts of a cell into elements.
class Tessellator : public PartVisitor {
 public:
  /// Elements are about `spacing` wide along each axis; vertices are kept within `limits`.
  Tessellator(const Box& limits, const Point& spacing, Tessellation& out)
      : limits_(limits), spacing_(spacing), out_(out) {}

  void full(const Box& box, const Frame* frame) override;
  void reduced(const ActiveSet& active, const LineSegment& line) override;
  void reduced(const Reduction2D& reduction) override;

 private:
  /// A part of the lines between two breakpoints, from one end to another.
  struct Strip {
    LineEnd low;
    LineEnd high;
  };

  int add_vertex(const Point& local);
  int steps(double length, int axis) const;
  void add_element(std::array<int, 4> corners, bool reversed);
  void add_boundary(const ActiveSet& active, int surface, int first, int second);
  void add_strip(const Reduction2D& reduction, const Strip& strip, double from, double to);
  void add_side(const Reduction2D& reduction, const LineCrossing& side, double from, double to);
  void add_wall(const Reduction2D& reduction, const Reduction2D::Wall& wall);

  Box limits_;
  Point spacing_;
  Tessellation& out_;
  const Frame* frame_ = nullptr;
};

}  // namespace rfm
