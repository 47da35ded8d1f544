#include "core/operations_page.hpp"

#include "core/expression_tokens.hpp"
#include "core/operations.hpp"

namespace rfm {
namespace {

std::string call_of(const OperationRow& row) {
  switch (row.operation) {
    case Operation::negate:
      return "-a";
    case Operation::integer_power:
      return "a^n";
    case Operation::real_power:
      return "a^r";
    case Operation::power:
      return "a^b, pow(a, b)";
    case Operation::less:
      return "a < b, b > a";
    case Operation::less_equal:
      return "a <= b, b >= a";
    case Operation::equal:
      return "a == b, 1 - (a != b)";
    default:
      break;
  }
  const std::string name(row.name);
  if (!is_name(name)) return "a " + name + " b";
  std::string call = name + "(a";
  for (int i = 1; i < row.arity; ++i) call += std::string(", ") + "abc"[i];
  return call + (row.numbers > 0 ? ", n)" : ")");
}

// A vertical bar would end the cell.
std::string cell(std::string_view text, std::string_view if_empty) {
  std::string result;
  for (const char letter : text.empty() ? if_empty : text)
    result += letter == '|' ? std::string("\\|") : std::string(1, letter);
  return result;
}

}  // namespace

std::string operations_page() {
  std::string page = "| in text | value | defined where | not smooth where |\n|---|---|---|---|\n";
  for (const OperationRow& row : operation_table)
    page += "| `" + call_of(row) + "` | " + cell(row.formula, "") + " | " +
            cell(row.domain, "everywhere") + " | " + cell(row.not_smooth, "-") + " |\n";
  return page;
}

}  // namespace rfm
