#pragma once

#include <bitset>
#include <span>
#include <vector>

#include "core/boolean.hpp"

namespace rfm {

/// What the signs of some variables of an expression tell of those of others: "where a is true, b
/// is false". Of half-planes along a convex curve, in a small box, each may hold the next.
class Implications {
 public:
  static constexpr int most_variables = 64;
  /// Among these variables (numbers in expressions). Throws `InvalidArgument` if there are more
  /// than `most_variables`.
  explicit Implications(std::span<const int> variables);

  /// Where the variable number `first` of the list is `of_first`, the other is `of_second`; so
  /// where the other is not, the first is not.
  void add(int first, bool of_first, int second, bool of_second);

 private:
  friend class ImpliedSigns;
  // Variable i of the list being true is 2i, being false 2i + 1.
  using Literals = std::bitset<2 * most_variables>;
  static int literal(int variable, bool truth) { return 2 * variable + (truth ? 0 : 1); }

  std::vector<int> place_;  // in the list, by number; −1 for others
  std::vector<Literals> implied_;
};

/// An expression with the same values wherever the implications hold, without operands that they
/// make needless: in a & b a false b has to matter only where a is true, so that b can go if a
/// implies it, wherever b stands beside a or below something beside it; and likewise for a | b
/// where a is false. Negations end up at the variables. The expression itself if it is too long
/// for that (a graph with shared parts, written out, may be).
BooleanExpression with_implications(const BooleanExpression& expression,
                                    const Implications& implications);

}  // namespace rfm
