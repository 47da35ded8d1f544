#include "core/operations.hpp"

#include <algorithm>
#include <cmath>

namespace rfm {

const OperationRow* find_operation(Operation operation) {
  // The rows follow each other as the enumerators do, after leaves and nodes with a payload.
  constexpr int first = static_cast<int>(operation_table[0].operation);
  const int row = static_cast<int>(operation) - first;
  return row < 0 ? nullptr : &operation_table[row];
}

const OperationRow* find_operation(std::string_view name) {
  const auto* row = std::ranges::find(operation_table, name, &OperationRow::name);
  return row == operation_table.end() ? nullptr : row;
}

bool is_defined_everywhere(const OperationRow& row, double number) {
  const bool whole_power =
      number > 0 && number == std::floor(number) &&
      (row.operation == Operation::integer_power || row.operation == Operation::real_power);
  return row.domain.empty() || whole_power;
}

std::string objection_to_number(Operation operation, double number) {
  const auto whole_within = [number](double least, double most) {
    return number == std::floor(number) && number >= least && number <= most;
  };
  switch (operation) {
    case Operation::integer_power:
      return whole_within(-64, 64) ? "" : "a whole number from -64 to 64";
    case Operation::real_power:
      return std::isfinite(number) ? "" : "a finite number";
    case Operation::ralpha_conjunction:
    case Operation::ralpha_disjunction:
      return number > -1 && number <= 1 ? "" : "a number > -1 and <= 1";
    case Operation::rp_conjunction:
    case Operation::rp_disjunction:
      return whole_within(2, 64) && std::fmod(number, 2) == 0 ? ""
                                                              : "an even whole number from 2 to 64";
    case Operation::rp_equivalence:
      return whole_within(1, 64) ? "" : "a whole number from 1 to 64";
    default:
      return "";
  }
}

}  // namespace rfm
