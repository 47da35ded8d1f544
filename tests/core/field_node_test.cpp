#include "core/field_node.hpp"

#include <gmock/gmock.h>

#include <memory>

#include "core/error.hpp"
#include "core/spline_field.hpp"
#include "core/tape.hpp"
#include "tests/core/operation_rows.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate(), z = z_coordinate();

class EveryRow : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(FieldNode, EveryRow, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return info.param.identifier; });

TEST_P(EveryRow, GetsOtherArgumentsWithTheSameNumber) {
  const OperationRow& row = *find_operation(GetParam().operation);
  const auto made = [&](std::vector<Field> arguments) {
    arguments.resize(static_cast<std::size_t>(row.arity));
    return apply(row.operation, arguments,
                 row.numbers ? std::optional(GetParam().number) : std::nullopt);
  };
  std::vector<Field> others{sin(z), x + y, x * z};
  others.resize(static_cast<std::size_t>(row.arity));
  EXPECT_TRUE(same_expression(with_arguments(made({x, y, z}), others), made(others)));
  others.pop_back();
  EXPECT_THROW(with_arguments(made({x, y, z}), others), InvalidArgument);
}

TEST(FieldNode, NewArgumentsSimplifyAndFold) {
  EXPECT_TRUE(with_arguments(x * y, {x, 1.0}).same_as(x));
  EXPECT_EQ(with_arguments(hypot(x, y), {3.0, 4.0}).constant(), 5);
  EXPECT_TRUE(with_arguments(partial(x * x, 0), {y}).is_constant(0));
  EXPECT_TRUE(with_arguments(x, {}).same_as(x));
}

TEST(FieldNode, SampledFieldsAtPlacesKnowWhichDerivativeTheyAre) {
  const auto spline = std::make_shared<SplineField>(Grid({2, {0, 0}, {1, 1}}, {1, 1, 1}), 0,
                                                    std::vector<double>{2.0});
  for (const MultiIndex& alpha : {MultiIndex{}, MultiIndex{1, 0}, MultiIndex{16, 3}})
    EXPECT_EQ(source_derivative(field_at(spline, {x, y}, alpha).node().index), alpha);
  EXPECT_THROW(field_at(spline, {x}), InvalidArgument);
  EXPECT_THROW(field_at(nullptr, {x, y}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
