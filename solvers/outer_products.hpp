#pragma once

#include <experimental/simd>
#include <span>

namespace rfm {

/// Vectors of one batch of numbers per processor instruction.
using SimdVector = std::experimental::native_simd<double>;

/// Lengths of local vectors are rounded up to this, so that products work on whole registers.
inline constexpr int product_padding = static_cast<int>(SimdVector::size()) > 4
                                           ? static_cast<int>(SimdVector::size())
                                           : 4;
constexpr int padded(int count) {
  return (count + product_padding - 1) / product_padding * product_padding;
}

/// Two lists of vectors, one of each per point, point after point: a and b of `outer_products`.
struct VectorPair {
  const double* left = nullptr;
  const double* right = nullptr;
};

/// result[i + j · rows] = Σ_pairs Σ_points left[i] right[j], the product of small dense matrices
/// that assembly consists of. `rows` and `columns` are padded lengths. With `lower` only j ≤ i is
/// needed: blocks wholly above the diagonal keep what was there.
void outer_products(std::span<const VectorPair> pairs, int points, int rows, int columns,
                    bool lower, double* result);

/// A number and a vector per point.
struct WeightedVectors {
  const double* weights = nullptr;
  const double* vectors = nullptr;
};

/// At every point, result = Σ_terms weight · vector; `length` is a padded length.
void linear_combinations(std::span<const WeightedVectors> terms, int points, int length,
                         double* result);

/// result += Σ_points weight · vector.
void add_weighted_sum(const WeightedVectors& term, int points, int length, double* result);

}  // namespace rfm
