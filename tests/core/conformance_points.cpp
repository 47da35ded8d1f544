#include "tests/core/conformance_points.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace rfm {
namespace {

std::vector<double> special_numbers() {
  constexpr double pi = std::numbers::pi, tiny = std::numeric_limits<double>::denorm_min();
  std::vector<double> numbers{0.0,   -0.0,   tiny,  -tiny,   1e-310, -3e-309, 1e-200, -1e-160,
                              1e-8,  -1e-3,  1e10,  49,      1e15,   1e22,    -1e150, 1e154,
                              1e300, -1e300, 700.5, -745.25, 20,     0.3,     -0.7};
  const double exact[] = {0.5, -0.5, 1, -1, 2, -2, 3};
  const double rounded[] = {pi / 2, -pi / 2, pi, -pi, 1.5 * pi, -2 * pi, 100 * pi, 1e5 * pi};
  for (const double number : exact) numbers.push_back(number);
  for (const double number : rounded) numbers.push_back(number);
  for (const double number : {0.5, 1.0, -1.0, 2.0, -3.0, pi / 2, -pi, 100 * pi})
    for (const double towards : {-INFINITY, INFINITY})
      numbers.push_back(std::nextafter(number, towards));
  return numbers;
}

double any_number(std::mt19937_64& generator) {
  static const std::vector<double> special = special_numbers();
  std::uniform_real_distribution<double> uniform(-3, 3), exponent(-12, 12);
  switch (generator() % 4) {
    case 0:
      return uniform(generator);
    case 1:
      return (generator() % 2 ? 1 : -1) * std::pow(10, exponent(generator));
    default:
      return special[generator() % special.size()];
  }
}

}  // namespace

std::vector<Row> conformance_rows() {
  std::vector<Row> rows;
  for (const OperationRow& entry : operation_table) {
    std::string identifier;
#define RFM_NAME(id, ...) \
  if (entry.operation == Operation::id) identifier = #id;
    RFM_OPERATIONS(RFM_NAME)
#undef RFM_NAME
    if (entry.numbers == 0) {
      rows.push_back({entry.operation, identifier, 0});
      continue;
    }
    int variant = 0;
    for (const double number : {0.5, 2.0, 3.0, -1.0, -0.5, 1.7, 4.0, 64.0, 1.0, -1.3, -7.0, 66.0})
      if (objection_to_number(entry.operation, number).empty())
        rows.push_back({entry.operation, identifier + "_" + std::to_string(++variant), number});
  }
  return rows;
}

std::vector<Arguments> nasty_arguments(int arity, int count, std::mt19937_64& generator) {
  std::vector<Arguments> points;
  if (arity == 1) {
    std::vector<double> special = special_numbers();
    std::ranges::shuffle(special, generator);
    // Few points are half special and half of them of every scale, or high orders would be looked
    // at next to zero only.
    special.resize(std::min<std::size_t>(special.size(), (count + 1) / 2));
    for (const double number : special) points.push_back({number, 0, 0});
  }
  while (static_cast<int>(points.size()) < count) {
    Arguments at{any_number(generator), any_number(generator), any_number(generator)};
    switch (generator() % 8) {  // on and next to diagonals
      case 0:
        at[1] = at[0];
        break;
      case 1:
        at[1] = -at[0];
        break;
      case 2:
        at[1] = std::nextafter(at[0], at[2]);
        break;
      case 3:
        at[1] = at[0] * std::round(at[2]);
        if (!std::isfinite(at[1])) at[1] = 1;
        break;
      default:
        break;
    }
    points.push_back(at);
  }
  points.resize(count);
  return points;
}

std::vector<Arguments> arguments_of_every_size(int arity, int count, std::mt19937_64& generator) {
  std::vector<Arguments> points = nasty_arguments(arity, (count + 1) / 2, generator);
  std::uniform_real_distribution<double> uniform(-3, 3), exponent(-300, 300);
  const auto any_size = [&] {
    return (generator() % 4 ? 1 : -1) * std::pow(10, exponent(generator));
  };
  while (static_cast<int>(points.size()) < count) {
    Arguments at{any_size(), any_size(), any_size()};
    if (generator() % 4 != 0) at[1] = at[0] * uniform(generator);
    points.push_back(at);
  }
  return points;
}

}  // namespace rfm
