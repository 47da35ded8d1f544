#pragma once

#include <vector>

#include "core/tape.hpp"

namespace rfm {

/// A function of the position and of up to a few dozen slots, with its first and second derivatives
/// by the slots: energies W(x, d(u)) where the slots d(u) are u, its gradient and Hessian, of
/// several components. More variables than jets have: the function is differentiated node by node
/// (core/graph_derivative.hpp), and value, gradient and Hessian are the roots of one tape of order
/// 0, which shares what they have in common. So every slot costs what depends on it, and zeros and
/// constants are known before anything is evaluated.
///
///     const Field ux = further_coordinate(4), uy = further_coordinate(5);
///     const SlotFunction area(sqrt(1 + ux * ux + uy * uy), {4, 5});
///     Tape::Workspace workspace(area.tape());
///     area.tape().evaluate({.coordinates = …, .count = n, .further = slot_rows}, workspace);
///     for (const auto& entry : area.hessian())     // entry.row ≤ entry.column
///       … entry.root < 0 ? entry.constant : workspace.coefficient(entry.root)[point] …
class SlotFunction {
 public:
  /// A derivative that is not zero everywhere: constant, or a root of the tape.
  struct Entry {
    int row = 0, column = 0;  ///< slots by their place in the list; equal for the gradient
    int root = -1;            ///< −1: constant
    double constant = 0;
    bool depends_on_slots = false;  ///< else it depends on position, time and parameters alone
  };

  /// `slots` are the numbers of the coordinates (from 4 on) that are slots. Throws
  /// `InvalidArgument` on numbers below 4 and repeated ones.
  SlotFunction(const Field& function, std::vector<int> slots);

  int slot_count() const { return static_cast<int>(slots_.size()); }
  /// Root 0 is the value. All coordinates are held: position, time, slots and parameters are given
  /// with the points.
  const Tape& tape() const { return tape_; }
  const std::vector<Entry>& gradient() const { return gradient_; }
  /// The upper triangle, row by row; entries that are left out are zero everywhere.
  const std::vector<Entry>& hessian() const { return hessian_; }
  /// Whether the Hessian does not depend on the slots, so that the gradient is affine in them.
  bool is_quadratic() const;

 private:
  std::vector<Field> differentiated(const Field& function);

  std::vector<int> slots_;
  std::vector<Entry> gradient_, hessian_;
  Tape tape_;
};

}  // namespace rfm
