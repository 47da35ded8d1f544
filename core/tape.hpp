#pragma once

#include <array>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/field_source.hpp"
#include "core/line.hpp"
#include "core/point_block.hpp"
#include "core/variables.hpp"

namespace rfm {

/// Fields compiled for evaluation: the graph hash-consed, sorted, every node at the lowest order of
/// derivatives that its users need, registers reused. Immutable and shared by threads; each thread
/// evaluates with a `Workspace` of its own.
///
///     const Tape tape({u, f}, {2, 0}, 2);                  // u with second derivatives in 2D
///     Tape::Workspace workspace(tape);
///     tape.evaluate(points, workspace);
///     const double* u_xy = workspace.coefficient(0, jet_index(2, {1, 1}));   // [point]
///
/// Coefficients are Taylor coefficients ∂^α f / α!, in the order of `jet_index`, in up to four
/// variables: the coordinates of space, or any others, as in `Tape({u}, {2}, {0, 1, 3})` for x, y
/// and t. Orders go up to 16, counting those of derivatives within a field; 1 to 3 variables and
/// orders 0 to 3 (0 to 4 in 2D) have kernels of their own and are several times faster. A field
/// that needs more throws `InvalidArgument` at compilation.
class Tape {
 public:
  static constexpr int block_size = 64;

  /// `orders[i]` derivatives of `roots[i]`; one order may be given for all roots.
  Tape(std::vector<Field> roots, std::vector<int> orders, const Variables& variables);
  ~Tape();
  Tape(Tape&&) noexcept;
  Tape& operator=(Tape&&) noexcept;

  class Workspace;
  /// Jets of all roots at up to `block_size` points. Throws `InvalidArgument` for a workspace of
  /// another tape, and where the points lack what the fields depend on.
  void evaluate(const PointBlock& points, Workspace& workspace) const;
  /// Rigorous bounds of value and gradient of root `root` over a box (other coordinates are 0), by
  /// first-order Taylor models with interval remainders; the gradient, with respect to the tape's
  /// variables, is not bounded of a root of order 0. Throws `InvalidArgument` if low > high.
  FunctionBounds bounds(const Box& box, int root = 0, const OtherRanges& others = {}) const;
  /// Rigorous bounds of the value alone, by plain intervals: cheaper and wider.
  Interval value_bounds(const Box& box, int root = 0, const OtherRanges& others = {}) const;
  /// Rigorous bounds of the value of root `root`, which must be of order 1 at least, and of its
  /// derivative with respect to the parameter of a line, where that lies in `range`: as `bounds`,
  /// but of second order in the length alone, without a box around the line. For tapes in the
  /// coordinates of space.
  LineBounds bounds(const Line& line, const Interval& range, int root = 0,
                    const OtherRanges& others = {}) const;
  /// Value and gradient of root `root` at one point, without a workspace. The gradient needs a root
  /// of order 1 at least, and at most three variables, or else `InvalidArgument` is thrown.
  double value(const Point& point, int root = 0, const OtherValues& others = {}) const;
  double value_and_gradient(const Point& point, Point& gradient, int root = 0,
                            const OtherValues& others = {}) const;
  /// All Taylor coefficients of root `root` at one point, as many as its order has.
  std::vector<double> jet(const Point& point, int root = 0, const OtherValues& others = {}) const;

  /// The same functions for points and boxes within `box`, whatever all other coordinates are,
  /// without what bounds of the values over the box decide: the branch of a min, max or select that
  /// is not taken, |a| and the sign of an argument of one sign, comparisons and floors that are
  /// constant. Where the compared are equal up to rounding, the result is either of the branches. A
  /// cell of a grid sees a few of a thousand shapes that min and max join; specialise again for its
  /// parts. R₀-functions and Rα-functions for α < 1 have no branches: every argument counts
  /// everywhere.
  Tape specialised(const Box& box) const;

  /// The number of variables.
  int dimension() const { return variables_.count(); }
  const Variables& variables() const { return variables_; }
  int root_count() const { return static_cast<int>(roots_.size()); }
  /// Names of the parameters that the fields depend on, by number; empty where one has none.
  const std::vector<std::string>& parameter_names() const;
  int order(int root) const { return orders_[root]; }
  /// Operations of the expression, as single points and bounds evaluate it.
  int instruction_count() const;
  /// How many of them are left out where bounds decide them: what `specialised` can gain.
  int branch_count() const;
  /// Steps in which a block is evaluated: polynomials of degree ≤ 2 take one or two.
  int step_count() const;
  const std::vector<Field>& roots() const { return roots_; }

  struct Program;

 private:
  Tape(const Tape& general, const Box& box);
  const Program& with_steps() const;
  /// `root` if there is such a root. Throws `InvalidArgument` otherwise.
  int checked(int root) const;
  void coefficients(const Point& point, int root, const OtherValues& others,
                    std::span<double> first) const;

  std::vector<Field> roots_;
  std::vector<int> orders_;
  Variables variables_;
  std::shared_ptr<const Program> program_;
};

/// Whether two fields are the same expression, node by node (not whether they are equal functions).
bool same_expression(const Field& a, const Field& b);

/// Scratch memory and results of one thread. Valid for the tape it was made for, wherever that is
/// moved to; any other refuses it.
class Tape::Workspace {
 public:
  explicit Workspace(const Tape& tape);
  /// Coefficient `coefficient` of root `root` at the points of the last evaluation. Throws
  /// `InvalidArgument` if the tape has no such root, or the root no such coefficient.
  const double* coefficient(int root, int coefficient = 0) const {
    if (static_cast<std::size_t>(root) >= root_offset_.size() ||
        static_cast<unsigned>(coefficient) >= static_cast<unsigned>(root_size_[root]))
      refuse(root, coefficient);
    return data_ + root_offset_[root] + coefficient * block_size;
  }

 private:
  friend class Tape;
  [[noreturn]] void refuse(int root, int coefficient) const;

  std::shared_ptr<const Program> program_;  // that of the tape, as long as this exists
  std::vector<double> storage_;
  double* data_ = nullptr;  // aligned for SIMD
  std::vector<int> root_offset_, root_size_;
};

}  // namespace rfm
