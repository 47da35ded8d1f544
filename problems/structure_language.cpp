#include "problems/structure_language.hpp"

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "core/expression_text.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

constexpr const char *level_function = "level", *near_function = "near";
constexpr std::size_t longest_line = 100'000;

ExpressionFunction level_of(const Region& domain) {
  const auto value = [domain](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
    const ExpressionArgument& argument = arguments[0];
    for (const auto& primitive : domain.primitives())
      if (primitive->name == argument.text) return primitive->level;
    throw InputError("the domain is not made of '" + argument.text + "'", argument.offset,
                     argument.length);
  };
  return {1, 1, value, true};
}

ExpressionFunction near_of(const CellSides& cell) {
  const auto value = [cell](std::span<const ExpressionArgument> arguments) -> ExpressionValue {
    for (const ExpressionArgument& argument : arguments)
      if (argument.value.is_vector)
        throw InputError("a number is needed here, not a vector", argument.offset, argument.length);
    const Field& cells = arguments[1].value.components[0];
    if (!cells.is_constant() || !(cells.constant() > 0))
      throw InputError("a positive number of cells is needed here", arguments[1].offset,
                       arguments[1].length);
    return faded(arguments[0].value.components[0], cells.constant(), cell);
  };
  return {2, 2, value};
}

// What a text means, or nothing.
std::optional<Field> meaning(const std::string& text, const ExpressionScope& scope) {
  try {
    return to_field(Expression(text), scope);
  } catch (const InputError&) {
    return std::nullopt;
  }
}

void name_primitives(const Problem& problem, const ExpressionScope& scope, StructureNames& names) {
  for (const auto& primitive : problem.domain->primitives())
    for (const auto& [function, field] :
         {std::pair{"omega", &primitive->function}, std::pair{level_function, &primitive->level}}) {
      const std::string name = std::string(function) + "(" + primitive->name + ")";
      if (const auto meant = meaning(name, scope); meant && meant->same_as(*field))
        names.emplace_back(name, *field);
    }
}

// On one line, in parentheses unless it is a name.
std::string as_operand(std::string text) {
  std::ranges::replace(text, '\n', ' ');
  const bool is_name =
      std::ranges::all_of(text, [](unsigned char c) { return std::isalnum(c) != 0 || c == '_'; });
  return is_name ? text : "(" + text + ")";
}

void name_data(const Problem& problem, const std::vector<PieceCondition>& conditions,
               const ExpressionScope& scope, StructureNames& names) {
  for (const PieceCondition& piece : conditions)
    for (const Field& datum : piece.data) {
      if (datum.is_constant()) continue;
      for (const auto& [key, expression] : problem.conditions[piece.condition].data) {
        const auto meant = meaning(expression.text(), scope);
        if (!meant || !same_expression(*meant, datum)) continue;
        names.emplace_back(as_operand(expression.text()), datum);
        break;
      }
    }
}

void name_calls(const std::vector<Structure::Call>& calls, const ExpressionScope& scope,
                StructureNames& names) {
  for (const Structure::Call& call : calls) {
    ExpressionTextOptions options;
    options.names = names;
    std::string text = call.function + "(";
    for (std::size_t i = 0; i < call.arguments.size(); ++i)
      text += (i > 0 ? ", " : "") + to_text(call.arguments[i], options);
    text += ")";
    if (const auto meant = meaning(text, scope); meant && same_expression(*meant, call.value))
      names.emplace_back(text, call.value);
  }
}

}  // namespace

CellSides cell_sides(const Grid& grid) {
  CellSides sides{grid.dimension(), {}, grid.box().longest_side()};
  for (int axis = 0; axis < grid.dimension(); ++axis) sides.side[axis] = grid.spacing(axis);
  return sides;
}

Field faded(const Field& omega, double cells, const CellSides& cell) {
  // Far away where ω has no slope.
  const double farthest = 10 * cell.whole;
  const double widest = *std::ranges::max_element(cell.side);
  Field step = pow((widest / farthest) * omega, 2);
  for (int axis = 0; axis < cell.dimension; ++axis)
    step = step + pow(cell.side[axis] * partial(omega, axis), 2);
  return exp(-pow(omega / cells, 2) / step);
}

double cell_side(const Grid& grid) {
  double side = grid.spacing(0);
  for (int axis = 1; axis < grid.dimension(); ++axis) side = std::min(side, grid.spacing(axis));
  return side;
}

ExpressionScope structure_scope(const Problem& problem, int unknowns, const CellSides& cell) {
  ExpressionScope scope = problem.scope;
  define_structures(scope, problem.dimension, unknowns);
  if (!scope.has_function(level_function))
    scope.define_function(level_function, level_of(*problem.domain));
  if (!scope.has_function(near_function)) scope.define_function(near_function, near_of(cell));
  return scope;
}

std::optional<std::string> structure_line(const Structure& structure, const Problem& problem,
                                          const std::vector<PieceCondition>& conditions,
                                          const CellSides& cell,
                                          const std::vector<Structure::Call>& calls) {
  const ExpressionScope scope =
      structure_scope(problem, std::max(1, structure.unknown_count()), cell);
  StructureNames names;
  name_primitives(problem, scope, names);
  name_data(problem, conditions, scope, names);
  try {
    name_calls(calls, scope, names);
    std::string text = to_text(structure, names);
    if (text.size() <= longest_line) return text;
  } catch (const InvalidArgument&) {  // a function without a name, or too long by far
  }
  return std::nullopt;
}

}  // namespace rfm
