#include "solvers/outer_products.hpp"

#include <algorithm>

namespace rfm {
namespace {

using std::experimental::element_aligned;

constexpr int lanes = static_cast<int>(SimdVector::size());
constexpr int block_columns = 4;
static_assert(product_padding % block_columns == 0 && product_padding % lanes == 0);

// Some points of a pair of lists, short enough to stay in the first cache while all blocks of the
// result are formed from them.
struct Part {
  const double* left;
  const double* right;
  int points;
  bool first;
};
constexpr int cached_numbers = 1536;

// A block of `vectors` · lanes rows and four columns, held in registers over all points.
template <int vectors>
void add_block(const Part& part, int rows, int columns, int i, int j, double* result) {
  double* corner = result + i + j * rows;
  SimdVector sum[block_columns][vectors];
  for (int column = 0; column < block_columns; ++column)
    for (int v = 0; v < vectors; ++v)
      if (part.first)
        sum[column][v] = 0;
      else
        sum[column][v].copy_from(corner + v * lanes + column * rows, element_aligned);
  const double* left = part.left + i;
  const double* right = part.right + j;
  for (int q = 0; q < part.points; ++q, left += rows, right += columns) {
    SimdVector row[vectors];
    for (int v = 0; v < vectors; ++v) row[v].copy_from(left + v * lanes, element_aligned);
    for (int column = 0; column < block_columns; ++column)
      for (int v = 0; v < vectors; ++v) sum[column][v] += row[v] * right[column];
  }
  for (int column = 0; column < block_columns; ++column)
    for (int v = 0; v < vectors; ++v)
      sum[column][v].copy_to(corner + v * lanes + column * rows, element_aligned);
}

void add_part(const Part& part, int rows, int columns, bool lower, double* result) {
  for (int j = 0; j < columns; j += block_columns) {
    int i = lower ? j / product_padding * product_padding : 0;
    while (i < rows) {
      const int left = (rows - i) / lanes;
      if (left >= 3 && left != 4) {
        add_block<3>(part, rows, columns, i, j, result);
        i += 3 * lanes;
      } else if (left >= 2) {
        add_block<2>(part, rows, columns, i, j, result);
        i += 2 * lanes;
      } else {
        add_block<1>(part, rows, columns, i, j, result);
        i += lanes;
      }
    }
  }
}

// A number of terms known at compilation, which most integrands have.
template <int terms>
void combine(std::span<const WeightedVectors> list, int points, int length, double* result) {
  const double* vectors[terms];
  for (int t = 0; t < terms; ++t) vectors[t] = list[t].vectors;
  for (int q = 0; q < points; ++q) {
    SimdVector weights[terms];
    for (int t = 0; t < terms; ++t) weights[t] = list[t].weights[q];
    const std::ptrdiff_t begin = std::ptrdiff_t(q) * length;
    for (std::ptrdiff_t i = begin; i < begin + length; i += lanes) {
      SimdVector sum = weights[0] * SimdVector(vectors[0] + i, element_aligned);
      for (int t = 1; t < terms; ++t)
        sum += weights[t] * SimdVector(vectors[t] + i, element_aligned);
      sum.copy_to(result + i, element_aligned);
    }
  }
}

}  // namespace

void outer_products(std::span<const VectorPair> pairs, int points, int rows, int columns,
                    bool lower, double* result) {
  const int length = std::max(8, cached_numbers / std::max(rows, columns));
  bool first = true;
  for (const VectorPair& pair : pairs)
    for (int q = 0; q < points; q += length) {
      add_part({pair.left + std::ptrdiff_t(q) * rows, pair.right + std::ptrdiff_t(q) * columns,
                std::min(length, points - q), first},
               rows, columns, lower, result);
      first = false;
    }
}

void linear_combinations(std::span<const WeightedVectors> terms, int points, int length,
                         double* result) {
  switch (terms.size()) {
    case 1:
      return combine<1>(terms, points, length, result);
    case 2:
      return combine<2>(terms, points, length, result);
    case 3:
      return combine<3>(terms, points, length, result);
    default:
      break;
  }
  std::fill_n(result, std::ptrdiff_t(points) * length, 0.0);
  for (const auto& [weights, vectors] : terms)
    for (std::ptrdiff_t q = 0; q < points; ++q)
      for (std::ptrdiff_t i = q * length; i < (q + 1) * length; ++i)
        result[i] += weights[q] * vectors[i];
}

void add_weighted_sum(const WeightedVectors& term, int points, int length, double* result) {
  for (int i = 0; i < length; i += lanes) {
    SimdVector sum(result + i, element_aligned);
    const double* vector = term.vectors + i;
    for (int q = 0; q < points; ++q, vector += length)
      sum += term.weights[q] * SimdVector(vector, element_aligned);
    sum.copy_to(result + i, element_aligned);
  }
}

}  // namespace rfm
