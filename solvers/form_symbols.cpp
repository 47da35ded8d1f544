#include "solvers/form_symbols.hpp"

#include <algorithm>
#include <limits>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/field_node.hpp"
#include "core/field_source.hpp"
#include "core/further_coordinate.hpp"
#include "core/graph_derivative.hpp"
#include "core/graph_walk.hpp"

namespace rfm {
namespace {

// Stands in graphs; whoever evaluates it has forgotten to put a solution in, and sees NaN.
class Symbol : public FieldSource {
 public:
  Symbol(int component, SymbolRole role, int dimension)
      : component(component), role(role), dimension_(dimension) {}

  void evaluate(const std::array<const double*, 3>&, int count, int variables, int order,
                double* jets, int stride) const override {
    const int size = jet_size(variables, order);
    for (int c = 0; c < size; ++c)
      std::fill_n(jets + std::ptrdiff_t(c) * stride, count,
                  std::numeric_limits<double>::quiet_NaN());
  }
  FunctionBounds bounds(const Box&) const override {
    FunctionBounds bounds;
    bounds.value = Interval::entire();
    bounds.gradient.fill(Interval::entire());
    return bounds;
  }
  std::vector<double> breakpoints(int) const override { return {}; }
  Box valid() const override {
    Box box;
    box.dimension = dimension_;
    box.low.fill(-std::numeric_limits<double>::infinity());
    box.high.fill(std::numeric_limits<double>::infinity());
    return box;
  }

  const int component;
  const SymbolRole role;

 private:
  int dimension_;
};

const Symbol* symbol_of(const Field& field) {
  const Field::Node& node = field.node();
  if (node.operation != Operation::source) return nullptr;
  return dynamic_cast<const Symbol*>(node.source.get());
}

template <class Predicate>
bool any_symbol(const Field& formula, Predicate&& holds) {
  return any_node(formula, [&](const Field& field) {
    const Symbol* symbol = symbol_of(field);
    return symbol && holds(*symbol);
  });
}

// Derivatives of what contains symbols are carried out; others stay, since jets are cheaper.
Field with_derivatives_at_symbols(const Field& formula) {
  return walked<Field>(
      formula, [](const Field& leaf) { return leaf; },
      [](const Field& field, std::vector<Field> arguments) -> Field {
        const Field::Node& node = field.node();
        if (node.operation == Operation::partial && has_symbols(arguments[0]))
          return derivative_with_respect_to(arguments[0], coordinate(node.index));
        if (symbol_of(field)) return field;
        for (std::size_t i = 0; i < arguments.size(); ++i)
          if (!arguments[i].same_as(node.arguments[i]))
            return with_arguments(field, std::move(arguments));
        return field;
      });
}

// Calls replace(symbol) for every symbol, or derivative of one, of a formula made so.
template <class Replace>
Field with_symbols_replaced(const Field& formula, Replace&& replace) {
  return walked<Field>(
      formula, [&](const Field& leaf) { return symbol_of(leaf) ? replace(leaf) : leaf; },
      [&](const Field& field, std::vector<Field> arguments) -> Field {
        if (symbol_of(field)) return replace(field);
        for (std::size_t i = 0; i < arguments.size(); ++i)
          if (!arguments[i].same_as(field.node().arguments[i]))
            return with_arguments(field, std::move(arguments));
        return field;
      });
}

}  // namespace

Field unknown_symbol(int component, int dimension) {
  return field(std::make_shared<Symbol>(component, SymbolRole::unknown, dimension));
}

Field test_symbol(int component, int dimension) {
  return field(std::make_shared<Symbol>(component, SymbolRole::test, dimension));
}

Field held(const Field& formula, int dimension) {
  return with_symbols_replaced(
      with_derivatives_at_symbols(formula), [&](const Field& leaf) -> Field {
        const Symbol& symbol = *symbol_of(leaf);
        if (symbol.role != SymbolRole::unknown) return leaf;
        const Field own =
            field(std::make_shared<Symbol>(symbol.component, SymbolRole::held, dimension));
        return partial(own, source_derivative(leaf.node().index));
      });
}

Field SymbolSlot::field() const { return further_coordinate(coordinate); }

Field SlotNumbering::of_symbol(const Field& leaf) {
  const Symbol& symbol = *symbol_of(leaf);
  const Slot slot{symbol.component, source_derivative(leaf.node().index)};
  const auto known = std::find_if(slots_.begin(), slots_.end(), [&](const SymbolSlot& own) {
    return own.slot == slot && own.role == symbol.role;
  });
  if (known != slots_.end()) return known->field();
  slots_.push_back({slot, symbol.role, 4 + static_cast<int>(slots_.size())});
  return slots_.back().field();
}

Field SlotNumbering::replaced(const Field& formula) {
  return with_symbols_replaced(with_derivatives_at_symbols(formula),
                               [&](const Field& leaf) { return of_symbol(leaf); });
}

bool has_symbols(const Field& formula) {
  return any_symbol(formula, [](const Symbol&) { return true; });
}

bool has_test_symbols(const Field& formula) {
  return any_symbol(formula, [](const Symbol& symbol) { return symbol.role == SymbolRole::test; });
}

Field with_solution(const Field& formula, std::span<const Field> components) {
  return with_symbols_replaced(
      with_derivatives_at_symbols(formula), [&](const Field& leaf) -> Field {
        const Symbol& symbol = *symbol_of(leaf);
        if (symbol.role == SymbolRole::test ||
            symbol.component >= static_cast<int>(components.size()))
          throw InvalidArgument("a formula asks for a component that the solution does not have");
        return partial(components[symbol.component], source_derivative(leaf.node().index));
      });
}

}  // namespace rfm
