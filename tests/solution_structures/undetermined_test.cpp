#include "solution_structures/undetermined.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"
#include "core/evaluate.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();

TEST(Undetermined, SameNumberIsTheSameFunction) {
  EXPECT_TRUE(undetermined_function(3).same_as(undetermined_function(3)));
  EXPECT_FALSE(undetermined_function(3).same_as(undetermined_function(2)));
  EXPECT_EQ(undetermined_index(undetermined_function(3).node()), 3);
  EXPECT_FALSE(undetermined_index(x.node()));
}

TEST(Undetermined, OccursInWhateverIsMadeOfIt) {
  EXPECT_TRUE(has_undetermined(x * partial(undetermined_function(0), 1)));
  EXPECT_FALSE(has_undetermined(x * sin(y)));
}

TEST(Undetermined, HasNoValueUntilOneIsPutIn) {
  const Field formula = x * partial(undetermined_function(1), 0) + undetermined_function(0);
  EXPECT_TRUE(std::isnan(value_at(formula, {1, 2})));
  const std::vector<Field> functions{y, x * x * y};
  EXPECT_DOUBLE_EQ(value_at(with_functions(formula, functions), {3, 2}), 3 * (2 * 3 * 2) + 2);
}

TEST(Undetermined, FunctionsThatAreMissingAreRefused) {
  const std::vector<Field> one{x};
  EXPECT_THROW(with_functions(undetermined_function(1), one), InvalidArgument);
  EXPECT_THROW(undetermined_function(-1), InvalidArgument);
  EXPECT_THROW(undetermined_function(64), InvalidArgument);
}

}  // namespace
}  // namespace rfm
