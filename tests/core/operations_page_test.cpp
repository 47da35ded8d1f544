#include "core/operations_page.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <sstream>

#include "core/expression.hpp"
#include "core/operations.hpp"

namespace rfm {
namespace {

/// The cells of each line, without the blanks around them.
std::vector<std::vector<std::string>> rows() {
  std::vector<std::vector<std::string>> rows;
  std::istringstream page(operations_page());
  for (std::string line; std::getline(page, line);) {
    std::vector<std::string> cells{""};
    for (std::size_t i = 1; i < line.size(); ++i) {
      if (line[i] != '|' || line[i - 1] == '\\')
        cells.back() += line[i];
      else if (i + 1 < line.size())
        cells.emplace_back();
    }
    rows.push_back(cells);
  }
  return rows;
}

TEST(OperationsPage, HasARowOfFourCellsForEveryOperation) {
  const auto page = rows();
  ASSERT_EQ(page.size(), operation_table.size() + 2);
  for (const auto& cells : page) EXPECT_EQ(cells.size(), 4u) << cells[0];
}

TEST(OperationsPage, WritesOperationsAsFormulasThatAreRead) {
  ExpressionScope scope;
  for (const char* name : {"a", "b", "c"}) scope.define(name, x_coordinate());
  const auto page = rows();
  for (std::size_t i = 0; i < operation_table.size(); ++i) {
    const std::string& cell = page[i + 2][0];
    ASSERT_EQ(std::ranges::count(cell, '`'), 2) << cell;
    const OperationRow& row = operation_table[i];
    std::string formula = cell.substr(2, cell.size() - 4);
    const bool power = row.operation == Operation::power;
    if (row.operation == Operation::less || row.operation == Operation::less_equal ||
        row.operation == Operation::equal || power)
      formula = formula.substr(0, formula.find(", "));  // two ways to write it
    scope.define(
        "n", row.name.starts_with("ralpha") || row.operation == Operation::real_power ? 0.5 : 2.0);
    scope.define("r", 0.5);
    const Field read = to_field(Expression(formula), scope);
    EXPECT_EQ(read.node().operation, row.operation) << formula;
  }
}

}  // namespace
}  // namespace rfm
