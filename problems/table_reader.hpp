#pragma once

#include <string>
#include <vector>

#include "core/expression.hpp"

namespace rfm {

/// The points of a table.
struct TablePoints {
  std::vector<double> abscissae, values;
};

/// Reads two columns of numbers, separated by commas, semicolons or blanks; empty lines, lines that
/// begin with `#` and one line of titles before the numbers are passed over. `name` stands in
/// messages. Throws `InputError` with the line: `load.csv:3: expected a number but found 'abc'`.
TablePoints parse_table(const std::string& text, const std::string& name);

/// `table("file.csv", argument)` for formulas: the spline of core/table.hpp through the points of a
/// file in `folder` or below it. Files are read once.
ExpressionFunction table_function(const std::string& folder);

}  // namespace rfm
