#include "core/tape_memory.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/evaluate.hpp"

namespace rfm {
namespace {

TEST(ConstantPool, KeepsEqualConstantsOnce) {
  ConstantPool pool;
  const int two = pool.find({2, 1}), three = pool.find({3, 1});
  EXPECT_NE(two, three);
  EXPECT_EQ(pool.find({2, 1}), two);
  EXPECT_EQ(pool.find({3, 1}), three);
  const auto numbers = std::move(pool).numbers();
  EXPECT_EQ(numbers[three], 3);
  EXPECT_EQ(numbers[three + Tape::block_size], 1);
}

TEST(ConstantPool, TellsNaNAndZerosOfBothSignsApart) {
  ConstantPool pool;
  const int zero = pool.find({0.0}), negative = pool.find({-0.0}), none = pool.find({NAN});
  EXPECT_EQ(pool.find({NAN}), none);
  EXPECT_EQ(pool.find({0.0}), zero);
  const auto numbers = std::move(pool).numbers();
  EXPECT_FALSE(std::signbit(numbers[zero]));
  EXPECT_TRUE(std::signbit(numbers[negative]));
  EXPECT_TRUE(std::isnan(numbers[none]));
}

TEST(ConstantPool, BlocksSeeConstantsAsSinglePointsDo) {
  const Field x = x_coordinate(), y = y_coordinate();
  const auto in_block = [](const Field& f, const Point& at) {
    return evaluate(f, at, 1, 2).value();
  };
  const Field below = apply(Operation::less, {x, 0.0});
  EXPECT_TRUE(std::isnan(in_block(select(below, NAN, 0.0 * y) + y, {-1, 2})));
  EXPECT_TRUE(std::isnan(in_block(min(x, NAN), {-1, 0})));
  EXPECT_EQ(in_block(apply(Operation::atan2, {-0.0, x}), {-1, 0}), -std::numbers::pi);
  EXPECT_EQ(in_block(x / Field(-0.0), {-1, 0}), INFINITY);
}

TEST(RowPool, GivesRowsBackLastInFirstOut) {
  RowPool pool(64);
  const int first = pool.take(2), second = pool.take(2);
  EXPECT_EQ(first, 64);
  EXPECT_EQ(second, first + 2 * Tape::block_size);
  pool.give_back(first, 2);
  pool.give_back(second, 2);
  EXPECT_EQ(pool.take(2), second);
  EXPECT_EQ(pool.take(2), first);
  EXPECT_EQ(pool.take(1), second + 2 * Tape::block_size);
  EXPECT_EQ(pool.size(), second + 3 * Tape::block_size);
}

}  // namespace
}  // namespace rfm
