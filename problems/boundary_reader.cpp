#include "problems/boundary_reader.hpp"

#include <algorithm>
#include <filesystem>

#include "core/nearest_name.hpp"
#include "problems/condition_data.hpp"
#include "problems/interpolation.hpp"
#include "problems/region_choice.hpp"
#include "problems/reserved_names.hpp"
#include "problems/structure_options.hpp"

namespace rfm {
namespace {

bool is_piece_of(const Region& region, const std::string& name) {
  return std::ranges::any_of(region.primitives(),
                             [&](const auto& primitive) { return primitive->name == name; });
}

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

}  // namespace

std::vector<std::string> BoundaryReader::pieces_of(const std::string& name) {
  if (pieces_.empty())
    for (const auto& primitive : shapes_.domain()->primitives()) pieces_.insert(primitive->name);
  if (pieces_.contains(name)) return {name};
  std::vector<std::string> pieces;
  if (const auto shape = shapes_.shapes().find(name); shape != shapes_.shapes().end())
    for (const auto& primitive : shape->second.primitives())
      if (pieces_.contains(primitive->name)) pieces.push_back(primitive->name);
  return pieces;
}

BoundaryTarget BoundaryReader::target(const std::string& name, const Place& place) {
  if (const auto region = problem_.regions.find(name); region != problem_.regions.end()) {
    used_regions_.insert(name);
    BoundaryTarget target = region->second;
    target.place = place;
    return target;
  }
  BoundaryTarget target{name, BoundaryTarget::Kind::pieces, {}, {}, {}, {}, false, place};
  if (name == "rest") {
    target.kind = BoundaryTarget::Kind::rest;
    return target;
  }
  if (!shapes_.domain()) return target;  // reported; which pieces there are is unknown
  if (name == "all") {
    target.kind = BoundaryTarget::Kind::all;
    for (const auto& primitive : shapes_.domain()->primitives())
      target.pieces.push_back(primitive->name);
    return target;
  }
  target.pieces = pieces_of(name);
  if (!target.pieces.empty()) return target;
  if (problem_.sets.contains(name))
    throw InputError("'" + name +
                         "' is a set and no part of the boundary: conditions on sets have "
                         "entries of their own",
                     0, name.size());
  if (const OutlineSide* side = shapes_.side(name)) {
    for (const std::string& piece : side->pieces)
      if (pieces_.contains(piece)) target.pieces.push_back(piece);
    target.where = side->where;
    if (!target.pieces.empty()) return target;
  }

  const auto refuse = [&](const std::string& message) -> InputError {
    return InputError(message, 0, name.size());
  };
  const std::string shape_name = name.substr(0, name.find('.'));
  const auto shape = shapes_.shapes().find(shape_name);
  if (shape == shapes_.shapes().end()) {
    std::vector<std::string> known = {"all", "rest"};
    for (const auto& [region, meaning] : problem_.regions) known.push_back(region);
    for (const auto& primitive : shapes_.domain()->primitives()) known.push_back(primitive->name);
    for (const auto& [other, region] : shapes_.shapes()) known.push_back(other);
    std::string advice = did_you_mean(name, known);
    throw refuse("unknown boundary part '" + name + "'" + advice);
  }
  if (shape_name != name && !is_piece_of(shape->second, name)) {
    std::vector<std::string> sides;
    for (const auto& primitive : shape->second.primitives())
      if (primitive->name.starts_with(shape_name + "."))
        sides.push_back(primitive->name.substr(shape_name.size() + 1));
    const std::string side = name.substr(shape_name.size() + 1);
    throw refuse("'" + shape_name + "' has no side '" + side + "'" + did_you_mean(side, sides) +
                 (sides.empty() ? "" : "; its sides: " + joined(sides)));
  }
  throw refuse("'" + name + "' is not part of the boundary: the domain does not contain it");
}

std::vector<BoundaryTarget> BoundaryReader::targets(const DocumentNode& node) {
  std::vector<BoundaryTarget> targets;
  const auto add = [&](const DocumentNode& name) {
    if (!values_.fits(name)) return;
    for (const BoundaryTarget& earlier : targets)
      if (earlier.name == name.text)
        return values_.mistakes.add("'" + name.text + "' is named twice", name.place);
    if (auto found =
            values_.guarded<BoundaryTarget>(name, [&] { return target(name.text, name.place); }))
      targets.push_back(std::move(*found));
  };
  if (node.is_scalar()) add(node);
  for (const DocumentNode& item : node.items) add(item);
  if (node.is_list() && node.items.empty())
    values_.mistakes.add("expected the name of a part of the boundary", node.place);
  return targets;
}

void BoundaryReader::read_regions() {
  const DocumentNode* regions = values_.find(root_, "regions");
  if (!regions) return;
  for (const DocumentNode::Entry& entry : regions->entries) read_region(entry);
}

void BoundaryReader::read_region(const DocumentNode::Entry& entry) {
  std::string objection = objection_to_name(entry.key);
  if (objection.empty() && shapes_.shapes().contains(entry.key))
    objection = "the name '" + entry.key + "' is already that of a shape";
  if (!objection.empty()) return values_.mistakes.add(objection, entry.key_place);
  BoundaryTarget region{entry.key,      BoundaryTarget::Kind::pieces, {}, {}, {}, {}, false,
                        entry.key_place};
  if (values_.fits(entry.value)) {
    const DocumentNode* of = entry.value.is_map() ? values_.find(entry.value, "of") : &entry.value;
    if (of)
      read_parts(*of, entry.value, region);
    else
      read_chosen_by_geometry(entry.value, values_, shapes_,
                              std::filesystem::path(problem_.file).parent_path().string(), region);
  }
  problem_.regions.emplace(entry.key, std::move(region));
}

void BoundaryReader::read_parts(const DocumentNode& of, const DocumentNode& map,
                                BoundaryTarget& region) {
  for (BoundaryTarget& part : targets(of)) {
    if (part.kind == BoundaryTarget::Kind::rest || part.where || part.chosen_by_geometry)
      values_.mistakes.add("a region is made of shapes and sides, not of '" + part.name + "'",
                           part.place);
    region.pieces.insert(region.pieces.end(), part.pieces.begin(), part.pieces.end());
    const std::string shape = part.name.substr(0, part.name.find('.'));
    if (shapes_.shapes().contains(shape)) shapes_.mark_used(shape);
  }
  if (const DocumentNode* where = map.is_map() ? values_.find(map, "where") : nullptr)
    region.where = values_.field(*where);
}

void BoundaryReader::read_conditions() {
  const DocumentNode* conditions = values_.find(root_, "conditions");
  if (!conditions) return;
  problem_.conditions_place = conditions->place;
  for (const DocumentNode::Entry& entry : root_.entries)
    if (&entry.value == conditions) problem_.conditions_place = entry.key_place;
  if (const DocumentNode* windows = values_.find(root_, "windows"))
    for (const DocumentNode& window : windows->items)
      if (const DocumentNode* in = values_.find(window, "in");
          in && shapes_.shapes().contains(in->text))
        shapes_.mark_used(in->text);
  // Its names count as used, and its mistakes are reported with those of other keys.
  if (const DocumentNode* remainder = values_.find(root_, "remainder")) values_.field(*remainder);
  std::vector<std::string> sets;
  for (const auto& [name, set] : problem_.sets) sets.push_back(name);
  const bool interpolates = problem_.physics.type == PhysicsType::interpolation;
  if (interpolates) {
    check_interpolation_file(root_, values_);
    for (const auto& [name, shape] : shapes_.shapes())
      if (is_inner_shape(name, shapes_.shapes(), shapes_.domain())) sets.push_back(name);
  }
  for (const DocumentNode& item : conditions->items) {
    if (!values_.fits(item)) continue;
    if (interpolates) check_interpolated(item, values_);
    if (is_inner_condition(item, sets))
      mark_shapes(item);
    else
      read_condition(item);
  }
}

// Conditions inside the domain are read when structures are made (structure_options.hpp).
void BoundaryReader::mark_shapes(const DocumentNode& condition) {
  const DocumentNode* at = values_.find(condition, "at");
  if (!at) return;
  if (shapes_.shapes().contains(at->text)) shapes_.mark_used(at->text);
  for (const DocumentNode& name : at->items)
    if (shapes_.shapes().contains(name.text)) shapes_.mark_used(name.text);
}

void BoundaryReader::read_condition(const DocumentNode& node) {
  Condition condition;
  condition.place = node.place;
  if (const DocumentNode* at = values_.find(node, "at")) condition.targets = targets(*at);
  if (const DocumentNode* priority = values_.find(node, "priority"))
    condition.priority = values_.integer(*priority).value_or(0);
  if (const DocumentNode* enforce = values_.find(node, "enforce"))
    condition.enforcement =
        enforce->text == "weak" ? Condition::Enforcement::weak : Condition::Enforcement::structure;
  if (const DocumentNode* periodic = values_.find(node, "periodic"))
    if (const DocumentNode* to = values_.find(*periodic, "to"))
      for (BoundaryTarget& target : targets(*to)) condition.targets.push_back(std::move(target));
  read_condition_data(node, values_, problem_.physics, condition);
  problem_.conditions.push_back(std::move(condition));
}

void BoundaryReader::report_unused() {
  const DocumentNode* regions = values_.find(root_, "regions");
  if (!regions) return;
  std::set<std::string, std::less<>> named;
  if (!values_.mistakes.empty()) named = words_of(root_);
  for (const DocumentNode::Entry& entry : regions->entries)
    if (problem_.regions.contains(entry.key) && !used_regions_.contains(entry.key) &&
        !named.contains(entry.key))
      values_.mistakes.add("the region '" + entry.key + "' is not used", entry.key_place);
}

}  // namespace rfm
