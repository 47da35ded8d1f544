#pragma once

#include "quadrature/tessellation.hpp"

namespace rfm {

struct SectionColumns;

/// Turns the parts of a cell into elements.
class Tessellator : public PartVisitor {
 public:
  /// Elements are about `spacing` wide along each axis; vertices are kept within `limits`.
  Tessellator(const Box& limits, const Point& spacing, Tessellation& out)
      : limits_(limits), spacing_(spacing), out_(out) {}

  void full(const Box& box, const Frame* frame) override;
  void reduced(const ActiveSet& active, const LineSegment& line) override;
  void reduced(const Reduction2D& reduction) override;
  void reduced(Reduction3D& reduction) override;

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
  void add_wall(const Reduction2D& reduction, const Wall& wall);

  /// In 3D: the numbers of vertices in a lattice of columns (outer axis), rows and layers.
  struct Lattice {
    std::array<int, 3> cells{};
    std::vector<int> vertices;
    int& at(int column, int row, int layer) {
      return vertices[(column * (cells[1] + 1) + row) * (cells[2] + 1) + layer];
    }
  };
  void add_strip(Reduction3D& reduction, const SectionColumns& sections, int strip);
  void add_part(Reduction3D& reduction, const SectionColumns& sections, int strip,
                const LineEnd& low, const LineEnd& high);
  void add_side(Reduction3D& reduction, const SectionColumns& sections, int strip,
                const LineCrossing& side);
  void add_wall(Reduction3D& reduction, const SectionColumns& sections, const Wall& wall);
  void add_wall(Reduction3D& reduction, const Wall& wall);
  std::vector<std::vector<int>> sheet_between(const ActiveSet& active,
                                              const std::vector<LineSegment>& lines,
                                              const LineEnd& low, const LineEnd& high);
  void add_lattice(Lattice& lattice, bool right_handed);
  void add_sheet(const ActiveSet& active, int surface, const std::vector<std::vector<int>>& sheet,
                 bool reversed);

  Box limits_;
  Point spacing_;
  Tessellation& out_;
  const Frame* frame_ = nullptr;
};

/// Where a surface, or an end of the line, is on a line.
double position_on(const ActiveSet& active, const LineEnd& end, const LineSegment& line,
                   bool is_low);
/// Place i of `count` equal steps between two numbers, both of which are met exactly.
double interpolated(double from, double to, int i, int count);
/// Ends nearer than this part of the line are one vertex.
inline constexpr double same_vertex = 1e-12;

}  // namespace rfm
