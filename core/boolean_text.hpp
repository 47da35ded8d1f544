#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/region.hpp"

namespace rfm {

/// A Boolean expression of shapes as text, parsed but not yet given a meaning:
///
///     BooleanText("(plate & roof) - hole").region(shape_of_name)
///
/// Operators, tightest first: `!` (complement); `&` (intersection) and `-` (difference), left to
/// right; `^` (exclusive or); `|` (union). Nesting is limited to 250 levels.
class BooleanText {
 public:
  /// Throws `InputError`, with the place in `text`.
  explicit BooleanText(std::string text);

  const std::string& text() const { return text_; }
  struct Name {
    std::string name;
    std::size_t offset;
  };
  /// The shapes that the text names, in its order, repeated where it repeats them.
  std::vector<Name> names() const;
  /// The region, given the meaning of names. What `shape` throws passes through. Throws
  /// `InputError` on more than 100,000 operations (an exclusive or counts its arguments twice).
  Region region(const std::function<Region(const Name&)>& shape) const;
  /// The same as a Boolean expression, of which `r_function` makes an R-function of any fields.
  BooleanExpression expression(const std::function<BooleanExpression(const Name&)>& variable) const;
  /// With names for the variables 0, 1, …. Throws `InputError` on a name that is not among them.
  BooleanExpression expression(const std::vector<std::string>& variables) const;

 private:
  friend class BooleanTextParser;
  struct Node {
    enum class Kind : std::uint8_t { name, complement, intersection, difference, exclusive, join };
    Kind kind;
    std::size_t offset;
    std::size_t length;
  };
  template <class Value, class Named>
  Value folded(const Named& named) const;

  std::string text_;
  /// In the order of evaluation: arguments before their users.
  std::vector<Node> nodes_;
};

}  // namespace rfm
