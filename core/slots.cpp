#include "core/slots.hpp"

#include <algorithm>
#include <unordered_set>

#include "core/error.hpp"
#include "core/further_coordinate.hpp"
#include "core/graph_derivative.hpp"

namespace rfm {
namespace {

bool depends_on(const Field& field, const std::vector<int>& slots) {
  std::unordered_set<const Field::Node*> seen;
  std::vector<const Field::Node*> pending{&field.node()};
  while (!pending.empty()) {
    const Field::Node* node = pending.back();
    pending.pop_back();
    if (!seen.insert(node).second) continue;
    if (node->operation == Operation::coordinate && std::ranges::count(slots, node->index) > 0)
      return true;
    for (const Field& argument : node->arguments) pending.push_back(&argument.node());
  }
  return false;
}

}  // namespace

SlotFunction::SlotFunction(const Field& function, std::vector<int> slots)
    : slots_(std::move(slots)),
      tape_(differentiated(function), {0}, Variables(std::vector<int>{0})) {}

std::vector<Field> SlotFunction::differentiated(const Field& function) {
  std::vector<GraphDerivative> along;
  for (const int slot : slots_) {
    if (std::ranges::count(slots_, slot) > 1)
      throw InvalidArgument("slots are different coordinates");
    along.emplace_back(further_coordinate(slot));
  }
  std::vector<Field> roots{function};
  const auto add = [&](std::vector<Entry>& entries, int row, int column, const Field& f) {
    if (f.is_constant(0)) return;
    Entry entry{row, column, -1, 0, false};
    if (f.is_constant()) {
      entry.constant = f.constant();
    } else {
      entry.root = static_cast<int>(roots.size());
      entry.depends_on_slots = depends_on(f, slots_);
      roots.push_back(f);
    }
    entries.push_back(entry);
  };
  for (int i = 0; i < slot_count(); ++i) {
    // The value tells where the function is not defined.
    const Field slope = along[i].where_defined(function);
    add(gradient_, i, i, slope);
    for (int j = i; j < slot_count(); ++j) add(hessian_, i, j, along[j].where_defined(slope));
  }
  return roots;
}

bool SlotFunction::is_quadratic() const {
  return std::ranges::none_of(hessian_, &Entry::depends_on_slots);
}

}  // namespace rfm
