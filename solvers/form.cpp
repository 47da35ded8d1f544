#include "solvers/form.hpp"

#include <algorithm>
#include <iterator>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/field_node.hpp"
#include "core/graph_walk.hpp"
#include "core/slots.hpp"

namespace rfm {
namespace {

bool is_slot(const Field& field) {
  return field.node().operation == Operation::coordinate && field.node().index >= 4;
}

bool has_slots(const Field& formula) { return any_node(formula, is_slot); }

// Whether slots are in operations that jump or have corners, of which slopes do not tell: those of
// sign(u) are 0, those of |u| may be left out of a tangent.
bool has_slots_in_pieces(const Field& formula) {
  return any_node(formula, [](const Field& part) {
    switch (part.node().operation) {
      case Operation::abs:
      case Operation::sign:
      case Operation::min:
      case Operation::max:
      case Operation::step:
      case Operation::floor:
      case Operation::mod:
      case Operation::less:
      case Operation::less_equal:
      case Operation::equal:
      case Operation::select:
        return std::ranges::any_of(part.node().arguments, has_slots);
      default:
        return false;
    }
  });
}

// Slots replaced; what is multiplied by a slot that is nothing is nothing, too.
Field with_slots(const Field& formula, const std::vector<Field>& slots) {
  return walked<Field>(
      formula,
      [&](const Field& leaf) -> Field {
        return is_slot(leaf) ? slots[leaf.node().index - 4] : leaf;
      },
      [](const Field& field, std::vector<Field> arguments) -> Field {
        const Field::Node& node = field.node();
        bool same = true;
        for (std::size_t i = 0; i < arguments.size(); ++i)
          same = same && arguments[i].same_as(node.arguments[i]);
        if (same) return field;
        // A zero of the formula's own says where it is defined: 0 · log(u) is no number for u < 0.
        const auto vanished = [&](int i) {
          return arguments[i].is_constant(0) && !arguments[i].same_as(node.arguments[i]);
        };
        if (node.operation == Operation::multiply && (vanished(0) || vanished(1))) return 0.0;
        if (node.operation == Operation::divide && vanished(0)) return 0.0;
        return with_arguments(field, std::move(arguments));
      });
}

std::vector<Field> fields_of(const std::vector<SymbolSlot>& slots) {
  std::vector<Field> fields;
  for (const SymbolSlot& slot : slots) fields.push_back(slot.field());
  return fields;
}

std::vector<SymbolSlot> of_role(const std::vector<SymbolSlot>& slots, SymbolRole role) {
  std::vector<SymbolSlot> own;
  std::ranges::copy_if(slots, std::back_inserter(own),
                       [&](const SymbolSlot& slot) { return slot.role == role; });
  return own;
}

}  // namespace

Form Form::energy(const Field& density, FormPlace place) {
  if (has_test_symbols(density)) throw InvalidArgument("an energy has no test functions");
  Form form(Kind::energy, std::move(place));
  SlotNumbering numbering;
  form.density_ = numbering.replaced(density);
  form.slots_ = numbering.slots();
  const std::vector<SymbolSlot> unknowns = of_role(form.slots_, SymbolRole::unknown);
  const auto [gradient, hessian] = slot_derivatives(form.density_, fields_of(unknowns));
  for (const auto& [slot, slope] : gradient) form.residual_.push_back({unknowns[slot].slot, slope});
  for (const auto& [row, column, value] : hessian)
    form.add_tangent(unknowns[row].slot, unknowns[column].slot, value);
  if (has_slots_in_pieces(form.density_) &&
      std::ranges::none_of(form.residual_, [](const ResidualEntry& entry) {
        return has_slots_in_pieces(entry.value);
      }))
    throw InvalidArgument("an energy that jumps with the unknowns has no slope that tells of it");
  return form;
}

Form Form::weak(const Field& density, FormPlace place) {
  Form form(Kind::weak, std::move(place));
  SlotNumbering numbering;
  const Field formula = numbering.replaced(density);
  form.slots_ = numbering.slots();
  std::vector<Field> no_test;
  for (const SymbolSlot& slot : form.slots_)
    no_test.push_back(slot.role == SymbolRole::test ? 0.0 : slot.field());
  const auto refuse = [] {
    throw InvalidArgument("a weak form is linear in the test functions: each of its terms has one");
  };
  if (!with_slots(formula, no_test).is_constant(0)) refuse();
  const std::vector<SymbolSlot> tests = of_role(form.slots_, SymbolRole::test);
  const std::vector<SymbolSlot> trials = of_role(form.slots_, SymbolRole::unknown);
  for (const auto& [test, flux] : slot_gradient(formula, fields_of(tests))) {
    if (!slot_gradient(flux, fields_of(tests)).empty()) refuse();
    form.residual_.push_back({tests[test].slot, flux});
    for (const auto& [trial, value] : slot_gradient(flux, fields_of(trials)))
      form.add_tangent(tests[test].slot, trials[trial].slot, value);
  }
  return form;
}

Form Form::least_squares(const std::vector<Field>& residuals, const std::vector<Field>& weights,
                         FormPlace place) {
  if (!weights.empty() && weights.size() != residuals.size())
    throw InvalidArgument("least squares take a weight for each residual");
  Form form(Kind::least_squares, std::move(place));
  SlotNumbering numbering;
  std::vector<Field> formulas;
  for (const Field& residual : residuals) {
    if (has_test_symbols(residual)) throw InvalidArgument("a residual has no test functions");
    formulas.push_back(numbering.replaced(residual));
  }
  form.slots_ = numbering.slots();
  const std::vector<SymbolSlot> unknowns = of_role(form.slots_, SymbolRole::unknown);
  const std::size_t count = unknowns.size();
  std::vector<Field> forces(count, 0.0);
  for (std::size_t i = 0; i < formulas.size(); ++i) {
    const Field weight = weights.empty() ? Field(1.0) : weights[i];
    form.density_ = form.density_ + 0.5 * weight * formulas[i] * formulas[i];
    std::vector<Field> slopes(count, 0.0);
    for (const auto& [slot, slope] : slot_gradient(formulas[i], fields_of(unknowns)))
      slopes[slot] = slope;
    ResidualRow& row = form.rows_.emplace_back();
    row.value = sqrt(weight) * formulas[i];
    for (std::size_t s = 0; s < count; ++s)
      if (!slopes[s].is_constant(0))
        row.slopes.emplace_back(unknowns[s].slot, sqrt(weight) * slopes[s]);
    for (std::size_t s = 0; s < count; ++s) {
      forces[s] = forces[s] + product_or_nothing(weight * slopes[s], formulas[i]);
      for (std::size_t t = s; t < count; ++t)
        form.add_tangent(unknowns[s].slot, unknowns[t].slot,
                         weight * product_or_nothing(slopes[s], slopes[t]));
    }
  }
  for (std::size_t s = 0; s < count; ++s)
    if (!forces[s].is_constant(0)) form.residual_.push_back({unknowns[s].slot, forces[s]});
  return form;
}

void Form::add_tangent(const Slot& test, const Slot& trial, const Field& value) {
  if (value.is_constant(0)) return;
  for (TangentEntry& entry : tangent_)
    if (entry.test == test && entry.trial == trial) {
      entry.value = entry.value + value;
      return;
    }
  tangent_.push_back({test, trial, value});
}

bool Form::is_linear() const {
  if (std::ranges::any_of(tangent_,
                          [](const TangentEntry& entry) { return has_slots(entry.value); }))
    return false;
  return std::ranges::none_of(
             residual_,
             [](const ResidualEntry& entry) { return has_slots_in_pieces(entry.value); }) &&
         std::ranges::none_of(
             rows_, [](const ResidualRow& row) { return has_slots_in_pieces(row.value); });
}

int Form::derivative_order() const {
  int order = 0;
  for (const SymbolSlot& slot : slots_) order = std::max(order, degree(slot.slot.derivative));
  return order;
}

Form::Replacement Form::symbols(int dimension) const {
  Replacement symbols;
  for (const auto& [slot, role, coordinate] : slots_) {
    const Field symbol = role == SymbolRole::test ? test_symbol(slot.component, dimension)
                                                  : unknown_symbol(slot.component, dimension);
    const Field derivative = partial(symbol, slot.derivative);
    symbols.push_back(role == SymbolRole::held ? held(derivative, dimension) : derivative);
  }
  return symbols;
}

Field Form::residual(const Slot& test, int dimension) const {
  for (const ResidualEntry& entry : residual_)
    if (entry.test == test) return with_slots(entry.value, symbols(dimension));
  return 0.0;
}

Field Form::tangent(const Slot& test, const Slot& trial, int dimension) const {
  for (const TangentEntry& entry : tangent_)
    if ((entry.test == test && entry.trial == trial) ||
        (kind_ != Kind::weak && entry.test == trial && entry.trial == test))
      return with_slots(entry.value, symbols(dimension));
  return 0.0;
}

Contribution Form::at(const Replacement& slots) const {
  if (slots.size() != slots_.size())
    throw InvalidArgument("a form takes a value for each of its slots");
  Contribution result;
  result.place = place_.place;
  result.numbers = place_.numbers;
  result.where = place_.where;
  for (const ResidualEntry& entry : residual_)
    result.energy.add_load(entry.test, -with_slots(entry.value, slots));
  for (const TangentEntry& entry : tangent_) {
    const Field value = with_slots(entry.value, slots);
    if (kind_ == Kind::weak)
      result.couplings.push_back({entry.test, entry.trial, value});
    else
      result.energy.add_stiffness(entry.test, entry.trial, value);
  }
  return result;
}

Contribution Form::linear() const {
  if (!is_linear()) throw InvalidArgument("the form is not linear");
  return at(Replacement(slots_.size(), 0.0));
}

Form::Replacement Form::slots_of(std::span<const Field> components,
                                 std::span<const Field> held_components) const {
  Replacement slots;
  for (const SymbolSlot& slot : slots_) {
    if (slot.role == SymbolRole::test) {
      slots.emplace_back(0.0);
      continue;
    }
    const bool elsewhere = slot.role == SymbolRole::held && !held_components.empty();
    const std::span<const Field> own = elsewhere ? held_components : components;
    if (slot.slot.component >= static_cast<int>(own.size()))
      throw InvalidArgument("a form asks for a component that the solution does not have");
    slots.push_back(partial(own[slot.slot.component], slot.slot.derivative));
  }
  return slots;
}

Contribution Form::linearized(std::span<const Field> components,
                              std::span<const Field> held_components) const {
  return at(slots_of(components, held_components));
}

bool Form::holds_anything() const { return !of_role(slots_, SymbolRole::held).empty(); }

std::vector<Form::ResidualRow> Form::residual_rows(std::span<const Field> components) const {
  if (kind_ != Kind::least_squares) throw InvalidArgument("only least squares have residuals");
  const Replacement slots = slots_of(components);
  std::vector<ResidualRow> rows = rows_;
  for (ResidualRow& row : rows) {
    row.value = with_slots(row.value, slots);
    for (auto& [slot, slope] : row.slopes) slope = with_slots(slope, slots);
  }
  return rows;
}

Field Form::density(std::span<const Field> components) const {
  return with_slots(density_, slots_of(components));
}

}  // namespace rfm
