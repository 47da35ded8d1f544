#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>

#include "core/boolean.hpp"

namespace rfm {

/// A Boolean function of up to ten variables as the list of its 2ⁿ values, one bit each: whether a
/// point is inside is one look-up of the signs of the primitives there. An assignment is a number
/// whose bit v is the value of variable v.
class TruthTable {
 public:
  static constexpr int max_variables = 10;

  /// The constant `value`, of no variables.
  explicit TruthTable(bool value = false) { words_[0] = value; }
  /// `expression` as a function of `variables` (numbers of its variables: they become 0, 1, …); the
  /// others are replaced by their truth in `signs`, an unknown one by false. Throws
  /// `InvalidArgument` for more than `max_variables` variables.
  TruthTable(const BooleanExpression& expression, std::span<const int> variables,
             std::span<const Truth> signs);

  int variable_count() const { return variables_; }
  bool value(unsigned assignment) const { return words_[assignment >> 6] >> (assignment & 63) & 1; }
  bool depends_on(int variable) const;
  /// The value if it is the same for every assignment.
  std::optional<bool> constant() const;
  /// Replaces `variable` by a constant; later variables move up by one.
  void fix(int variable, bool value);
  /// The function (this) & v₁ & v₂ & … with `count` new variables after the present ones.
  TruthTable with_conditions(int count) const;

  /// The bits, 64 to a word, as few words as hold them; and back.
  std::span<const std::uint64_t> words() const { return {words_.data(), word_count()}; }
  TruthTable(int variables, std::span<const std::uint64_t> words);

 private:
  std::size_t word_count() const {
    return variables_ <= 6 ? 1 : std::size_t{1} << (variables_ - 6);
  }
  void set(unsigned assignment, bool value) {
    const std::uint64_t bit = std::uint64_t{1} << (assignment & 63);
    words_[assignment >> 6] =
        value ? words_[assignment >> 6] | bit : words_[assignment >> 6] & ~bit;
  }

  int variables_ = 0;
  std::array<std::uint64_t, (1 << max_variables) / 64> words_{};
};

}  // namespace rfm
