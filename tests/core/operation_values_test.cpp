#include <gmock/gmock.h>

#include <numbers>

#include "tests/core/operation_rows.hpp"

// Every operation against its definition in long double, at nasty arguments.
namespace rfm {
namespace {

// The reference of the table. What depends on something that is not a number is none either, but
// for the branch of an `if` that is not taken.
long double reference(const Row& row, long double a, long double b, long double c) {
  using std::pow, std::fabs, std::sqrt, std::cbrt, std::exp, std::log, std::sin, std::cos, std::tan,
      std::asin, std::acos, std::atan, std::atan2, std::sinh, std::cosh, std::tanh, std::asinh,
      std::erf, std::hypot, std::floor;
  const long double number = row.number;
  const int arity = find_operation(row.operation)->arity;
  if (std::isnan(a) || (arity == 2 && std::isnan(b))) return std::nan("");
  switch (row.operation) {
#define RFM_REFERENCE(id, name, arity, numbers, rule, reference, ...) \
  case Operation::id:                                                 \
    return static_cast<long double>(reference);
    RFM_OPERATIONS(RFM_REFERENCE)
#undef RFM_REFERENCE
    default:
      return std::nan("");
  }
}

class EveryValue : public testing::TestWithParam<Row> {};
INSTANTIATE_TEST_SUITE_P(OperationTable, EveryValue, testing::ValuesIn(all_rows()),
                         [](const auto& info) { return info.param.identifier; });

// 8 units of rounding of the value, and of what a rounding of the arguments does to it.
long double tolerance(const Row& row, std::array<long double, 3> arguments) {
  const auto value = [&](const auto& at) { return reference(row, at[0], at[1], at[2]); };
  const long double exact = value(arguments);
  long double condition = 0x1p-53L * std::fabs(exact);
  for (const int i : {0, 1, 2})
    for (const long double sign : {-1.0L, 1.0L}) {
      auto rounded = arguments;
      rounded[i] *= 1 + sign * 0x1p-53L;
      const long double change = std::fabs(value(rounded) - exact);
      if (std::isfinite(change)) condition += change;
    }
  // The definitions of R-functions are differences; their stable forms have tests of their own.
  if (row.operation >= Operation::r0_conjunction)
    condition += 0x1p-53L * (std::fabs(arguments[0]) + std::fabs(arguments[1]));
  return 8 * condition + 4 * std::numeric_limits<double>::denorm_min();
}

TEST_P(EveryValue, IsThatOfItsDefinitionAtNastyArguments) {
  constexpr double pi = std::numbers::pi, tiny = std::numeric_limits<double>::denorm_min();
  const double nasty[] = {0.0,  -0.0,  tiny, -tiny, 1e-310, 1e-200, -1e-160,     1e-8,     0.5,
                          1,    -1,    1.5,  -2,    pi / 2, pi,     -1.5 * pi,   100 * pi, 49,
                          1e10, -1e15, 1e22, 1e150, 1e300,  -1e300, std::nan("")};
  for (const double a : nasty)
    for (const double b : nasty) {
      using Plain = Jet<double, 1, 0>;
      const double found = GetParam()(Plain(a), Plain(b), Plain(0.75)).value();
      const long double expected = reference(GetParam(), a, b, 0.75L);
      if (std::isnan(expected)) {
        EXPECT_TRUE(std::isnan(found)) << "at " << a << ", " << b << ": " << found;
        continue;
      }
      if (std::fabs(expected) > 1e307L && !std::isfinite(found)) continue;  // overflow
      const long double margin = std::isfinite(expected) ? tolerance(GetParam(), {a, b, 0.75L}) : 0;
      EXPECT_TRUE(found == expected || std::fabs(found - expected) <= margin)
          << "at " << a << ", " << b << ": " << found << ", not " << double(expected) << " within "
          << double(margin);
    }
}

}  // namespace
}  // namespace rfm
