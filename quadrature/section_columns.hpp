#pragma once

#include "quadrature/reduction_3d.hpp"

namespace rfm {

/// An interval between breakpoints of the outer axis, seen at equally spaced columns, both ends
/// included: the breakpoints of the section in the middle, followed to every column.
struct SectionColumns {
  /// Outer coordinates of the columns.
  std::vector<double> columns;
  double middle = 0;
  std::vector<Reduction2D::Breakpoint> at_middle;
  /// The walls of the section in the middle.
  std::vector<Wall> walls;
  /// positions[column][breakpoint], ascending in each column.
  std::vector<std::vector<double>> positions;

  SectionColumns(Reduction3D& reduction, double from, double to, int steps);

  /// The largest distance of breakpoint `strip` from the next.
  double widest(int strip) const;

 private:
  std::vector<double> column_positions(const Reduction3D& reduction,
                                       const std::vector<Reduction2D::Breakpoint>& here,
                                       const std::vector<Reduction2D::Breakpoint>& near,
                                       const std::vector<Reduction2D::Breakpoint>& far) const;
  void fill_gaps();
};

}  // namespace rfm
