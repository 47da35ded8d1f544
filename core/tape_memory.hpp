#pragma once

#include <bit>
#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "core/tape_step.hpp"

namespace rfm {

/// Rows of a workspace for results: those of finished registers are reused last in, first out,
/// while they are in cache.
class RowPool {
 public:
  explicit RowPool(int first_free) : size_(first_free) {}
  int take(int rows) {
    auto& list = free(rows);
    if (list.empty()) return std::exchange(size_, size_ + rows * Tape::block_size);
    const int offset = list.back();
    list.pop_back();
    return offset;
  }
  void give_back(int offset, int rows) { free(rows).push_back(offset); }
  int size() const { return size_; }

 private:
  std::vector<int>& free(int rows) {
    if (static_cast<int>(free_.size()) <= rows) free_.resize(rows + 1);
    return free_[rows];
  }
  std::vector<std::vector<int>> free_;
  int size_;
};

/// Constant coefficients, equal ones kept once. A part of h coefficients is a column of eight
/// numbers in h rows of `block_size`, so that it is addressed like rows; eight parts lie side by
/// side.
class ConstantPool {
 public:
  /// The offset of a part with these coefficients, from the start of the pool.
  int find(const std::vector<double>& coefficients) {
    std::vector<std::uint64_t> bits;
    bits.reserve(coefficients.size());
    for (const double coefficient : coefficients)
      bits.push_back(std::bit_cast<std::uint64_t>(coefficient));
    const auto [place, inserted] = known_.try_emplace(std::move(bits), 0);
    if (inserted) place->second = add(coefficients);
    return place->second;
  }
  /// A part of its own, to be written later.
  int add(const std::vector<double>& coefficients) {
    const int rows = static_cast<int>(coefficients.size());
    Column& column = next_[rows];
    if (column.used == column.limit) {
      column.used = static_cast<int>(numbers_.size());
      column.limit = column.used + Tape::block_size;
      numbers_.resize(numbers_.size() + static_cast<std::size_t>(rows) * Tape::block_size);
    }
    const int offset = std::exchange(column.used, column.used + width);
    for (int i = 0; i < rows; ++i)
      std::fill_n(numbers_.begin() + offset + i * Tape::block_size, width, coefficients[i]);
    return offset;
  }
  std::vector<double> numbers() && { return std::move(numbers_); }

 private:
  static constexpr int width = 8;  // of the widest vector
  struct Column {
    int used = 0, limit = 0;
  };
  // By their bits: a NaN would be equal to all numbers, −0 is not 0.
  std::map<std::vector<std::uint64_t>, int> known_;
  std::map<int, Column> next_;
  std::vector<double> numbers_;
};

}  // namespace rfm
