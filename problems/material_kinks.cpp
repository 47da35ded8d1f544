#include "problems/material_kinks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <set>

#include "problems/structure_options.hpp"

namespace rfm {
namespace {

using Names = std::set<std::string>;

Names boundaries_of(const Region& region) {
  Names names;
  for (const auto& primitive : region.primitives()) names.insert(primitive->name);
  return names;
}

bool has_conductivity(const Material& material) {
  return std::ranges::any_of(
      std::initializer_list<const char*>{"diffusivity", "conductivity", "tension"},
      [&](const char* key) { return material.coefficients.contains(key); });
}

}  // namespace

std::vector<std::string> kink_notes(const Problem& problem) {
  if (problem.physics.custom) return {};
  Names interfaces;
  for (const InterfaceCondition& interface : structure_options(problem).interfaces)
    interfaces.merge(boundaries_of(interface.region));
  const Names of_domain = boundaries_of(*problem.domain);
  std::vector<std::string> notes;
  for (const Material& material : problem.physics.materials) {
    if (!material.region || !has_conductivity(material)) continue;
    bool has_interface = false, is_left_out = false;
    for (const std::string& name : boundaries_of(*material.region)) {
      has_interface = has_interface || interfaces.contains(name);
      is_left_out = is_left_out || !(interfaces.contains(name) || of_domain.contains(name));
    }
    if (has_interface && !is_left_out) continue;
    notes.push_back(fmt::format(
        "the conductivity changes at the boundary of '{}', where u has a kink that splines smooth "
        "over: {{at: shape, interface: {{jump: 0}}}} lets its slope jump there",
        material.text));
  }
  return notes;
}

}  // namespace rfm
