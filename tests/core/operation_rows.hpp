#pragma once

#include <cmath>
#include <ostream>
#include <string>
#include <vector>

#include "core/scalar.hpp"

// The rules of jets are templates over the kind of number. With these they also work with long
// double, the reference by which rounding margins of bounds are judged; the rules look such names
// up where they are defined, so that these come before them.
namespace rfm {
inline bool less(long double a, long double b) { return a < b; }
inline bool less_equal(long double a, long double b) { return a <= b; }
inline bool equal(long double a, long double b) { return a == b; }
inline bool farther_from_zero(long double a, long double b) { return std::fabs(a) > std::fabs(b); }
inline long double select(bool condition, long double yes, long double no) {
  return condition ? yes : no;
}
inline long double square(long double a) { return a * a; }
inline long double nan_where_nan(long double value, long double argument) {
  return std::isnan(argument) ? argument : value;
}
inline bool less_or_nan(long double a, long double b) { return a < b || std::isnan(a); }
inline bool greater_or_nan(long double a, long double b) { return a > b || std::isnan(a); }
inline long double power(long double a, long double exponent) { return std::pow(a, exponent); }
inline long double power(long double a, double exponent) {
  return power(a, static_cast<long double>(exponent));
}
inline long double whole_of_product(long double a, double b) { return std::nearbyint(a * b); }
inline long double part_of_product(long double a, double b) {
  return a * b - whole_of_product(a, b);
}
}  // namespace rfm

#include "core/operation_rules.hpp"

namespace rfm {

// A row of the table, with one of the numbers that it may have.
struct Row {
  Operation operation;
  std::string identifier;
  double number = 0;
  friend void PrintTo(const Row& row, std::ostream* out) { *out << row.identifier; }

  template <class Number>
  Number operator()(const Number& a, const Number& b, const Number& c) const {
    return apply_rule(operation, a, b, c, number);
  }
};

inline std::vector<double> numbers_of(Operation operation) {
  switch (operation) {
    case Operation::integer_power:
      return {2, 3, -1};
    case Operation::real_power:
      return {0.5, 1.7, -1.3};
    case Operation::ralpha_conjunction:
    case Operation::ralpha_disjunction:
      return {-0.5, 0.5, 1};
    case Operation::rp_equivalence:
      return {1, 3, 4};
    case Operation::rp_conjunction:
    case Operation::rp_disjunction:
      return {2, 4, 6};
    default:
      return {0};
  }
}

inline std::vector<Row> all_rows() {
  std::vector<Row> rows;
  const auto add = [&](Operation operation, const std::string& identifier) {
    int variant = 0;
    for (const double number : numbers_of(operation))
      rows.push_back(
          {operation, identifier + (++variant > 1 ? "_" + std::to_string(variant) : ""), number});
  };
#define RFM_TEST_ROW(id, ...) add(Operation::id, #id);
  RFM_OPERATIONS(RFM_TEST_ROW)
#undef RFM_TEST_ROW
  return rows;
}

}  // namespace rfm
