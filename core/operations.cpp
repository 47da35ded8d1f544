#include "core/operations.hpp"

#include <algorithm>

namespace rfm {

const OperationRow* find_operation(Operation operation) {
  const auto* row = std::ranges::find(operation_table, operation, &OperationRow::operation);
  return row == operation_table.end() ? nullptr : row;
}

const OperationRow* find_operation(std::string_view name) {
  const auto* row = std::ranges::find(operation_table, name, &OperationRow::name);
  return row == operation_table.end() ? nullptr : row;
}

}  // namespace rfm
