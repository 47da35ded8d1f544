#include "core/instruction_table.hpp"

#include <gmock/gmock.h>

#include <cmath>

namespace rfm {
namespace {

class Instructions : public testing::Test {
 protected:
  int leaf(Operation operation, int index = 0, double number = 0) {
    Instruction instruction;
    instruction.operation = operation;
    instruction.index = index;
    instruction.number = number;
    return table.add(instruction);
  }
  int constant(double number) { return leaf(Operation::constant, 0, number); }
  int add(Operation operation, int a, int b = -1) {
    Instruction instruction;
    instruction.operation = operation;
    instruction.operands = {a, b, -1};
    return table.add(instruction);
  }
  Instruction last() {
    const std::vector<Instruction> all = InstructionTable(table).take();
    return all.back();
  }

  InstructionTable table;
  int x = leaf(Operation::coordinate, 0), y = leaf(Operation::coordinate, 1);
};

TEST_F(Instructions, KeepsEqualInstructionsOnce) {
  const int sum = add(Operation::add, x, y), sine = add(Operation::sin, sum);
  EXPECT_EQ(add(Operation::add, x, y), sum);
  EXPECT_EQ(add(Operation::sin, add(Operation::add, x, y)), sine);
  EXPECT_NE(add(Operation::subtract, y, x), add(Operation::subtract, x, y));
  EXPECT_NE(leaf(Operation::parameter, 0), x);
  // 0 and −0 are different numbers.
  EXPECT_NE(constant(0.0), constant(-0.0));
}

TEST_F(Instructions, CarriesOutOperationsOnConstantsButThoseThatFail) {
  EXPECT_EQ(add(Operation::multiply, constant(3), constant(4)), constant(12));
  const int root = add(Operation::sqrt, constant(-1));
  EXPECT_EQ(last().operation, Operation::sqrt);
  EXPECT_NE(root, constant(0));
}

TEST_F(Instructions, AppliesIdentitiesThatRoundNothing) {
  const int minus = add(Operation::negate, y);
  EXPECT_EQ(add(Operation::add, x, minus), add(Operation::subtract, x, y));
  EXPECT_EQ(add(Operation::negate, minus), y);
  EXPECT_EQ(add(Operation::abs, minus), add(Operation::abs, y));
  EXPECT_EQ(add(Operation::min, x, x), x);
  add(Operation::divide, x, constant(4));
  EXPECT_EQ(last().operation, Operation::scale);
  EXPECT_EQ(last().number, 0.25);
}

TEST_F(Instructions, DividesByWhatHasNoExactInverse) {
  add(Operation::divide, x, constant(3));
  EXPECT_EQ(last().operation, Operation::divide);
}

TEST_F(Instructions, DoesNotMultiplyAwayWhatMayBeUndefined) {
  const int root = add(Operation::sqrt, x);
  const int product = add(Operation::multiply, root, constant(0));
  EXPECT_NE(product, constant(0));
  EXPECT_FALSE(table.is_defined_everywhere(root));
  EXPECT_TRUE(table.is_defined_everywhere(add(Operation::sin, x)));
}

}  // namespace
}  // namespace rfm
