#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/multi_index.hpp"

namespace rfm {

/// The tables of jets in a number of variables and up to an order that are known at run time: what
/// `JetTables` and `jet_product_terms` (core/jet_product.hpp) are at compile time, in the same
/// order. Immutable; there is one of each, made when first asked for, and it lives as long as the
/// program.
class JetShape {
 public:
  struct Term {
    std::uint16_t left, right;
  };

  /// Throws `InvalidArgument` unless 1 ≤ variables ≤ 4 and 0 ≤ order ≤ 16.
  static const JetShape& get(int variables, int order);

  int variables() const { return variables_; }
  int order() const { return order_; }
  int size() const { return static_cast<int>(exponents_.size()); }
  /// Number of coefficients of degree ≤ `degree`.
  int size(int degree) const { return sizes_[degree]; }
  const MultiIndex& exponent(int i) const { return exponents_[i]; }
  /// The terms of which coefficient `result` of a product is the sum, by their left factors.
  std::span<const Term> product_terms(int result) const {
    return {terms_.data() + first_term_[result], terms_.data() + first_term_[result + 1]};
  }
  /// The place of α + e_axis in a jet of one order more, α being the multi-index of place `i`.
  int raised(int axis, int i) const { return raised_[axis][i]; }

 private:
  JetShape(int variables, int order);

  int variables_, order_;
  std::vector<int> sizes_;
  std::vector<MultiIndex> exponents_;
  std::vector<Term> terms_;
  std::vector<std::uint32_t> first_term_;
  std::array<std::vector<std::uint16_t>, maximum_variables> raised_;
};

}  // namespace rfm
