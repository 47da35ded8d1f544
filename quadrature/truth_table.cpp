#include "quadrature/truth_table.hpp"

#include <algorithm>
#include <string>
#include <vector>

#include "core/error.hpp"

namespace rfm {
namespace {

using Words = std::array<std::uint64_t, (1 << TruthTable::max_variables) / 64>;

// Bit a of word(v) is bit v of the assignment a: the table of variable v, v < 6.
constexpr std::array<std::uint64_t, 6> variable_patterns = {0xaaaaaaaaaaaaaaaa, 0xcccccccccccccccc,
                                                            0xf0f0f0f0f0f0f0f0, 0xff00ff00ff00ff00,
                                                            0xffff0000ffff0000, 0xffffffff00000000};

std::uint64_t variable_word(int variable, std::size_t word) {
  if (variable < 6) return variable_patterns[variable];
  return word >> (variable - 6) & 1 ? ~std::uint64_t{0} : 0;
}

}  // namespace

TruthTable::TruthTable(const BooleanExpression& expression, std::span<const int> variables,
                       std::span<const Truth> signs)
    : variables_(static_cast<int>(variables.size())) {
  if (variables_ > max_variables)
    throw InvalidArgument("a truth table has at most " + std::to_string(max_variables) +
                          " variables, not " + std::to_string(variables_));
  // All 2ⁿ assignments at once, 64 to a word.
  const std::size_t count = word_count();
  const auto& nodes = expression.nodes();
  std::vector<Words> values(nodes.size());
  for (std::size_t n = 0; n < nodes.size(); ++n) {
    const auto& node = nodes[n];
    Words& result = values[n];
    using Kind = BooleanExpression::Kind;
    const auto place = std::find(variables.begin(), variables.end(), node.first);
    for (std::size_t word = 0; word < count; ++word) switch (node.kind) {
        case Kind::constant:
          result[word] = node.first ? ~std::uint64_t{0} : 0;
          break;
        case Kind::variable:
          result[word] = place != variables.end()
                             ? variable_word(static_cast<int>(place - variables.begin()), word)
                         : signs[node.first] == Truth::yes ? ~std::uint64_t{0}
                                                           : 0;
          break;
        case Kind::negation:
          result[word] = ~values[node.first][word];
          break;
        case Kind::conjunction:
          result[word] = values[node.first][word] & values[node.second][word];
          break;
        case Kind::disjunction:
          result[word] = values[node.first][word] | values[node.second][word];
          break;
      }
  }
  words_ = values.back();
  if (variables_ < 6) words_[0] &= (std::uint64_t{1} << (1 << variables_)) - 1;
}

TruthTable::TruthTable(int variables, std::span<const std::uint64_t> words)
    : variables_(variables) {
  std::copy(words.begin(), words.end(), words_.begin());
}

bool TruthTable::depends_on(int variable) const {
  if (variable < 6) {
    const int shift = 1 << variable;
    for (std::size_t word = 0; word < word_count(); ++word)
      if ((words_[word] >> shift ^ words_[word]) & ~variable_patterns[variable] &
          (variables_ < 6 ? (std::uint64_t{1} << (1 << variables_)) - 1 : ~std::uint64_t{0}))
        return true;
    return false;
  }
  const std::size_t distance = std::size_t{1} << (variable - 6);
  for (std::size_t word = 0; word < word_count(); ++word)
    if (!(word & distance) && words_[word] != words_[word | distance]) return true;
  return false;
}

std::optional<bool> TruthTable::constant() const {
  for (int variable = 0; variable < variables_; ++variable)
    if (depends_on(variable)) return std::nullopt;
  return value(0);
}

void TruthTable::fix(int variable, bool value) {
  TruthTable rest;
  rest.variables_ = variables_ - 1;
  const unsigned below = (1u << variable) - 1, chosen = value ? 1u << variable : 0;
  for (unsigned assignment = 0; assignment < 1u << rest.variables_; ++assignment)
    rest.set(assignment, this->value((assignment & below) | (assignment & ~below) << 1 | chosen));
  *this = rest;
}

TruthTable TruthTable::with_conditions(int count) const {
  TruthTable result;
  result.variables_ = variables_ + count;
  if (result.variables_ > max_variables)
    throw InvalidArgument("too many conditions for a truth table");
  const unsigned all = ((1u << count) - 1) << variables_;
  for (unsigned assignment = 0; assignment < 1u << variables_; ++assignment)
    result.set(assignment | all, value(assignment));
  return result;
}

}  // namespace rfm
