#include "core/boolean_minimization.hpp"

#include <algorithm>
#include <bit>
#include <set>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr int variables_of_all_primes = 8;
constexpr int most_variables = 10;

bool covers_any(const Cube& product, std::span<const Cube> points) {
  return std::ranges::any_of(points, [&](const Cube& point) { return covers(product, point); });
}

bool covers_any_strictly(const Cube& product, std::span<const Cube> points) {
  return std::ranges::any_of(points,
                             [&](const Cube& point) { return covers_strictly(product, point); });
}

int literal_count(const Cube& product) {
  return static_cast<int>(
      std::ranges::count_if(product, [](Truth literal) { return literal != Truth::unknown; }));
}

// The product without the literals it can spare, tried from `first` on in cyclic order.
Cube expanded(Cube product, std::size_t first, std::span<const Cube> off) {
  for (std::size_t i = 0; i < product.size(); ++i) {
    Truth& literal = product[(first + i) % product.size()];
    const Truth was = literal;
    if (was == Truth::unknown) continue;
    literal = Truth::unknown;
    if (covers_any(product, off)) literal = was;
  }
  return product;
}

// All products of `on` cubes' literals, and those to which they expand, that avoid `off`.
std::vector<Cube> primes(std::span<const Cube> on, std::span<const Cube> off) {
  std::set<Cube> found;
  const std::size_t variables = on[0].size();
  for (const Cube& cube : on)
    for (std::size_t first = 0; first < std::max<std::size_t>(variables, 1); ++first) {
      found.insert(expanded(cube, first, off));
      if (variables > 64) break;  // one order: the number of cubes makes up for it
    }
  if (variables > variables_of_all_primes) return {found.begin(), found.end()};
  // Every prime is the expansion of one of its products; all 3ⁿ are tried.
  std::size_t count = 1;
  for (std::size_t v = 0; v < variables; ++v) count *= 3;
  for (std::size_t code = 0; code < count; ++code) {
    Cube product(variables);
    std::size_t rest = code;
    for (Truth& literal : product) {
      literal = static_cast<Truth>(static_cast<int>(rest % 3) - 1);
      rest /= 3;
    }
    if (covers_any(product, off) || !covers_any_strictly(product, on)) continue;
    if (expanded(product, 0, off) == product) found.insert(product);
  }
  return {found.begin(), found.end()};
}

/// Chooses the fewest products (then the fewest literals) that cover all points, by branch and
/// bound over the points that fewest products cover.
class CoverSearch {
 public:
  CoverSearch(const std::vector<Cube>& products, std::span<const Cube> points)
      : products_(products), covering_(points.size()) {
    for (std::size_t p = 0; p < points.size(); ++p)
      for (std::size_t c = 0; c < products.size(); ++c)
        if (covers_strictly(products[c], points[p])) covering_[p].push_back(static_cast<int>(c));
  }

  std::vector<Cube> run() {
    best_ = greedy();
    best_cost_ = cost(best_);
    std::vector<int> chosen;
    search(chosen);
    std::vector<Cube> result;
    std::ranges::sort(best_);
    for (const int c : best_) result.push_back(products_[c]);
    return result;
  }

 private:
  // Products count far more than literals.
  long cost(const std::vector<int>& chosen) const {
    long sum = 0;
    for (const int c : chosen) sum += 1'000'000 + literal_count(products_[c]);
    return sum;
  }

  bool is_covered(std::size_t point, const std::vector<int>& chosen) const {
    return std::ranges::any_of(covering_[point],
                               [&](int c) { return std::ranges::find(chosen, c) != chosen.end(); });
  }

  std::vector<int> greedy() const {
    std::vector<int> chosen;
    std::vector<std::size_t> open(covering_.size());
    for (std::size_t p = 0; p < open.size(); ++p) open[p] = p;
    while (!open.empty()) {
      std::vector<int> gain(products_.size(), 0);
      for (const std::size_t p : open)
        for (const int c : covering_[p]) ++gain[c];
      int best = covering_[open[0]][0];
      for (std::size_t c = 0; c < products_.size(); ++c)
        if (gain[c] > gain[best] ||
            (gain[c] == gain[best] && literal_count(products_[c]) < literal_count(products_[best])))
          best = static_cast<int>(c);
      chosen.push_back(best);
      std::erase_if(open, [&](std::size_t p) { return is_covered(p, chosen); });
    }
    // Without those that later ones have made superfluous.
    std::vector<int> needed;
    for (std::size_t i = 0; i < chosen.size(); ++i) {
      std::vector<int> others = needed;
      others.insert(others.end(), chosen.begin() + static_cast<std::ptrdiff_t>(i) + 1,
                    chosen.end());
      for (std::size_t p = 0; p < covering_.size(); ++p)
        if (!is_covered(p, others)) {
          needed.push_back(chosen[i]);
          break;
        }
    }
    return needed;
  }

  void search(std::vector<int>& chosen) {
    if (++steps_ > most_steps || cost(chosen) + (chosen.empty() ? 0 : 1) > best_cost_) return;
    const std::vector<int>* fewest = nullptr;
    for (std::size_t p = 0; p < covering_.size(); ++p)
      if (!is_covered(p, chosen) && (!fewest || covering_[p].size() < fewest->size()))
        fewest = &covering_[p];
    if (!fewest) {
      if (cost(chosen) < best_cost_) {
        best_ = chosen;
        best_cost_ = cost(chosen);
      }
      return;
    }
    if (cost(chosen) + 1'000'000 >= best_cost_) return;
    for (const int c : *fewest) {
      chosen.push_back(c);
      search(chosen);
      chosen.pop_back();
    }
  }

  static constexpr int most_steps = 20'000;
  const std::vector<Cube>& products_;
  std::vector<std::vector<int>> covering_;  // products by point
  std::vector<int> best_;
  long best_cost_ = 0;
  int steps_ = 0;
};

int literals_in(std::span<const Cube> cubes) {
  int sum = 0;
  for (const Cube& cube : cubes) sum += literal_count(cube);
  return sum;
}

}  // namespace

BooleanExpression sum_of_products(std::span<const Cube> cubes) {
  BooleanExpression sum = BooleanExpression::constant(false);
  for (const Cube& cube : cubes) {
    BooleanExpression product = BooleanExpression::constant(true);
    for (std::size_t v = 0; v < cube.size(); ++v) {
      const BooleanExpression variable = BooleanExpression::variable(static_cast<int>(v));
      if (cube[v] == Truth::yes) product = product & variable;
      if (cube[v] == Truth::no) product = product & !variable;
    }
    sum = sum | product;
  }
  return sum;
}

bool covers(const Cube& product, const Cube& signs) {
  for (std::size_t v = 0; v < product.size(); ++v)
    if (static_cast<int>(product[v]) * static_cast<int>(signs[v]) < 0) return false;
  return true;
}

bool covers_strictly(const Cube& product, const Cube& signs) {
  for (std::size_t v = 0; v < product.size(); ++v)
    if (product[v] != Truth::unknown && product[v] != signs[v]) return false;
  return true;
}

std::optional<std::vector<Cube>> minimal_cover(std::span<const Cube> on,
                                               std::span<const Cube> off) {
  if (on.empty()) return std::vector<Cube>{};
  for (const Cube& cube : on)
    if (covers_any(cube, off)) return std::nullopt;
  return CoverSearch(primes(on, off), on).run();
}

BooleanExpression minimal_expression(std::span<const Truth> table) {
  const int variables = std::bit_width(table.size()) - 1;
  if (!std::has_single_bit(table.size()) || variables > most_variables)
    throw InvalidArgument("a truth table has 2^n rows, n from 0 to 10, got " +
                          std::to_string(table.size()) + " rows");
  std::vector<Cube> on, off;
  for (std::size_t row = 0; row < table.size(); ++row) {
    if (table[row] == Truth::unknown) continue;
    Cube cube;
    for (int v = 0; v < variables; ++v)
      cube.push_back((row >> v & 1) != 0 ? Truth::yes : Truth::no);
    (table[row] == Truth::yes ? on : off).push_back(std::move(cube));
  }
  // Of complete signs either cover exists; ¬(sum of products of the complement) is the other form.
  const std::vector<Cube> sum = *minimal_cover(on, off), complement = *minimal_cover(off, on);
  if (off.empty()) return BooleanExpression::constant(!on.empty());
  if (literals_in(complement) < literals_in(sum))
    return (!sum_of_products(complement)).negations_at_leaves();
  return sum_of_products(sum);
}

BooleanExpression minimal_expression(const BooleanExpression& expression) {
  const int variables = expression.variable_count();
  if (variables > most_variables)
    throw InvalidArgument("an expression of " + std::to_string(variables) +
                          " variables is too large to minimise; at most 10");
  std::vector<Truth> table;
  for (std::size_t row = 0; row < std::size_t{1} << variables; ++row) {
    std::vector<Truth> signs;
    for (int v = 0; v < variables; ++v)
      signs.push_back((row >> v & 1) != 0 ? Truth::yes : Truth::no);
    table.push_back(expression.evaluate(signs));
  }
  return minimal_expression(table);
}

}  // namespace rfm
