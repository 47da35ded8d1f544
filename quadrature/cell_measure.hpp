#pragma once

namespace rfm {

/// Sums of the weights of a rule.
struct CellMeasure {
  double volume = 0;
  double boundary = 0;
  double interfaces = 0;
};

}  // namespace rfm
