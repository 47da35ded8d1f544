#include "solvers/form_loads.hpp"

#include <gtest/gtest.h>

#include "core/evaluate.hpp"
#include "solvers/form_symbols.hpp"

namespace rfm {
namespace {

const Field x = x_coordinate(), y = y_coordinate();
const Field u = unknown_symbol(0, 2), v = unknown_symbol(1, 2);

// Both for u = sin(x + 2 y), v = x y.
void expect_stored(const Field& density, const Field& expected) {
  const std::vector<Field> solution{sin(x + 2.0 * y), x * y};
  for (const Point& point : {Point{0.3, 0.7}, Point{-1, 0.2}})
    EXPECT_NEAR(value_at(with_solution(without_loads(density), solution), point),
                value_at(with_solution(expected, solution), point), 1e-14);
}

TEST(FormLoads, AreTheTermsThatAreLinearInTheUnknowns) {
  const Field stored = 0.5 * (pow(partial(u, 0), 2) + pow(partial(u, 1), 2));
  expect_stored(stored - exp(x) * u, stored);
  expect_stored(stored - (x * u - 3.0 * partial(v, 0)) + u * v, stored + u * v);
  expect_stored(-(x * u - stored) / (2.0 + x * x), stored / (2.0 + x * x));
  expect_stored(x * (stored - u) - 2.0 * partial(u, 0), x * stored);
}

TEST(FormLoads, LeaveWhatDoesNotDependOnTheUnknownsAndWhatIsNotLinear) {
  const Field area = sqrt(1.0 + pow(partial(u, 0), 2));
  expect_stored(area - u, area);
  expect_stored(7.0 * x + u * u * u + u, 7.0 * x + u * u * u);
  expect_stored(pow(u - x, 2), pow(u - x, 2));
}

TEST(FormLoads, MayBeAll) { expect_stored(x * u + partial(v, 1), 0.0); }

}  // namespace
}  // namespace rfm
