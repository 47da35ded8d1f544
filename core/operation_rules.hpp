#pragma once

#include "core/dynamic_jet.hpp"
#include "core/error.hpp"
#include "core/jet.hpp"
#include "core/jet_functions.hpp"
#include "core/jet_inverse_functions.hpp"
#include "core/jet_piecewise.hpp"
#include "core/jet_powers.hpp"
#include "core/jet_r_functions.hpp"
#include "core/jet_third_side.hpp"
#include "core/operations.hpp"
#include "core/r_rules.hpp"
#include "core/taylor_bound.hpp"

namespace rfm {

/// Applies a row of the operation table, known at compile time, to its arguments (those beyond its
/// arity are ignored). `Number` is a jet over any kind of number, `number` the constant of an
/// operation that has one.
template <Operation operation, class Number>
Number apply_rule(const Number& a, [[maybe_unused]] const Number& b,
                  [[maybe_unused]] const Number& c, [[maybe_unused]] double number = 0) {
#define RFM_APPLY(id, name, arity, numbers, rule, ...) \
  if constexpr (operation == Operation::id) return rule;
  RFM_OPERATIONS(RFM_APPLY)
#undef RFM_APPLY
}

/// The same for an operation known at run time.
template <class Number>
Number apply_rule(Operation operation, const Number& a, const Number& b, const Number& c,
                  double number = 0) {
  switch (operation) {
#define RFM_CASE(id, ...) \
  case Operation::id:     \
    return apply_rule<Operation::id>(a, b, c, number);
    RFM_OPERATIONS(RFM_CASE)
#undef RFM_CASE
    default:
      throw InvalidArgument("this operation has no row in the table");
  }
}

}  // namespace rfm
