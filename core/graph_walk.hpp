#pragma once

#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// Works out a value of every node of a graph from its leaves upwards, and returns that of the
/// root: `leaf(field)` for nodes without arguments, `inner(field, values of its arguments)` for the
/// others. Each node is visited once; graphs may be arbitrarily deep.
template <class Value, class Leaf, class Inner>
Value walked(const Field& root, const Leaf& leaf, const Inner& inner) {
  std::unordered_map<const Field::Node*, Value> known;
  std::vector<Field> pending{root};
  while (!pending.empty()) {
    const Field field = pending.back();
    const Field::Node& node = field.node();
    if (known.contains(&node)) {
      pending.pop_back();
      continue;
    }
    bool ready = true;
    for (const Field& argument : node.arguments)
      if (!known.contains(&argument.node())) {
        pending.push_back(argument);
        ready = false;
      }
    if (!ready) continue;
    pending.pop_back();
    if (node.arguments.empty()) {
      known.emplace(&node, leaf(field));
      continue;
    }
    std::vector<Value> arguments;
    for (const Field& argument : node.arguments) arguments.push_back(known.at(&argument.node()));
    known.emplace(&node, inner(field, std::move(arguments)));
  }
  return known.at(&root.node());
}

/// Whether `holds(field)` for any node of a graph. Each node is visited once; graphs may be
/// arbitrarily deep.
template <class Predicate>
bool any_node(const Field& root, const Predicate& holds) {
  std::unordered_set<const Field::Node*> seen;
  std::vector<Field> pending{root};
  while (!pending.empty()) {
    const Field field = pending.back();
    pending.pop_back();
    if (!seen.insert(&field.node()).second) continue;
    if (holds(field)) return true;
    for (const Field& argument : field.node().arguments) pending.push_back(argument);
  }
  return false;
}

}  // namespace rfm
