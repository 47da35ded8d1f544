#include <algorithm>
#include <array>

#include "core/expression_tokens.hpp"
#include "problems/reserved_names.hpp"
#include "problems/result_scope.hpp"
#include "problems/run_reader.hpp"

namespace rfm {
namespace {

class ProbeReader {
 public:
  ProbeReader(ValueReader& values, ShapeReader& shapes, BoundaryReader& boundary,
              const std::map<std::string, ThinSet>& sets)
      : values_(values), shapes_(shapes), boundary_(boundary), sets_(sets) {
    const int dimension = values.dimension;
    inside_ = values.scope;
    define_results(inside_, values.results);
    refuse_normal(inside_, dimension, "is known on a boundary only");
    on_boundary_ = inside_;
    define_normal(on_boundary_, stand_in_normal(dimension));
    define_boundary_results(on_boundary_, values.results, stand_in_normal(dimension));
  }

  Probe read(const DocumentNode::Entry& entry) {
    Probe probe;
    probe.name = entry.key;
    probe.place = entry.key_place;
    const DocumentNode& map = entry.value;
    if (const DocumentNode* point = values_.find(map, "point")) {
      probe.kind = Probe::Kind::point;
      if (const auto place = values_.point(*point)) probe.points = {*place};
      read_values(map, probe);
    } else if (const DocumentNode* line = values_.find(map, "line")) {
      probe.kind = Probe::Kind::line;
      read_line(*line, map, probe);
      read_values(map, probe);
    } else {
      read_integral(map, probe);
    }
    return probe;
  }

 private:
  void read_line(const DocumentNode& line, const DocumentNode& map, Probe& probe) {
    if (line.items.size() != 2)
      values_.mistakes.add("expected the two ends of a segment but found " +
                               std::to_string(line.items.size()) + " points",
                           line.place);
    for (const DocumentNode& end : line.items)
      if (const auto point = values_.point(end)) probe.points.push_back(*point);
    if (const DocumentNode* count = values_.find(map, "points"))
      probe.point_count = values_.integer(*count).value_or(100);
  }

  void read_values(const DocumentNode& map, Probe& probe) {
    const DocumentNode* value = values_.find(map, "value");
    if (!value) return;
    if (value->is_scalar()) add_value(value->text, *value, inside_, probe);
    for (const DocumentNode& item : value->items) add_value(item.text, item, inside_, probe);
    for (const DocumentNode::Entry& entry : value->entries)
      add_value(entry.key, entry.value, inside_, probe);
    if (value->items.empty() && value->entries.empty() && !value->is_scalar())
      values_.mistakes.add("expected a formula", value->place);
  }

  void add_value(const std::string& key, const DocumentNode& node, const ExpressionScope& scope,
                 Probe& probe) {
    const bool is_repeated = std::ranges::any_of(
        probe.values, [&](const auto& earlier) { return earlier.first == key; });
    if (is_repeated) return values_.mistakes.add("'" + key + "' is given twice", node.place);
    if (auto expression = values_.deferred(node, scope))
      probe.values.emplace_back(key, std::move(*expression));
  }

  void read_integral(const DocumentNode& map, Probe& probe) {
    if (const DocumentNode* over = values_.find(map, "over")) {
      const auto found = values_.guarded<bool>(*over, [&] {
        find_range(*over, probe);
        return true;
      });
      if (!found) return;
    }
    const auto kinds =
        std::to_array<std::pair<const char*, Probe::Kind>>({{"integral", Probe::Kind::integral},
                                                            {"average", Probe::Kind::average},
                                                            {"max", Probe::Kind::max},
                                                            {"min", Probe::Kind::min}});
    for (const auto& [key, kind] : kinds) {
      const DocumentNode* node = values_.find(map, key);
      if (!node) continue;
      probe.kind = kind;
      const bool is_on_boundary = probe.over == Probe::Over::boundary;
      const ExpressionScope& scope = is_on_boundary ? on_boundary_ : inside_;
      if (auto expression = values_.deferred(*node, scope)) {
        check_scalar(*node, *expression, scope);
        probe.values.emplace_back(node->text, std::move(*expression));
      }
    }
  }

  void check_scalar(const DocumentNode& node, const DeferredExpression& expression,
                    const ExpressionScope& scope) {
    values_.guarded<Field>(node, [&] { return expression.field(scope); });
  }

  // The domain, a region of the boundary, a shape that bounds the domain (its boundary), or another
  // shape (its inside).
  void find_range(const DocumentNode& over, Probe& probe) {
    const std::string& name = over.text;
    if (name == "domain") return;
    if (const auto set = sets_.find(name); set != sets_.end()) {
      if (set->second.points.size() == 1)
        throw InputError("'" + name + "' is a point: use a probe with 'point'", 0, name.size());
      probe.over = Probe::Over::set;
      probe.set = set->second;
      return;
    }
    const std::string shape = name.substr(0, name.find('.'));
    const bool is_shape = shapes_.shapes().contains(shape);
    if (is_shape) shapes_.mark_used(shape);
    const bool is_inclusion = is_shape && shape == name && !bounds_domain(name);
    if (is_inclusion) {
      probe.over = Probe::Over::shape;
      probe.region = shapes_.shapes().at(name);
      return;
    }
    probe.over = Probe::Over::boundary;
    if (name == "boundary") {
      probe.boundary = boundary_.target("all", over.place);
      return;
    }
    if (name == "rest")
      throw InputError("'rest' has no meaning here: name a part of the boundary", 0, name.size());
    probe.boundary = boundary_.target(name, over.place);
  }

  bool bounds_domain(const std::string& shape) const {
    if (!shapes_.domain()) return true;
    for (const auto& primitive : shapes_.shapes().at(shape).primitives())
      for (const auto& side : shapes_.domain()->primitives())
        if (side->name == primitive->name) return true;
    return false;
  }

  ValueReader& values_;
  ShapeReader& shapes_;
  BoundaryReader& boundary_;
  const std::map<std::string, ThinSet>& sets_;
  ExpressionScope inside_;
  ExpressionScope on_boundary_;
};

}  // namespace

void read_probes(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                 BoundaryReader& boundary, Problem& problem) {
  const DocumentNode* probes = values.find(root, "probes");
  if (!probes) return;
  ProbeReader reader(values, shapes, boundary, problem.sets);
  for (const DocumentNode::Entry& entry : probes->entries) {
    if (!is_name(entry.key))
      values.mistakes.add(objection_to_name(entry.key), entry.key_place);
    else if (values.fits(entry.value))
      problem.probes.push_back(reader.read(entry));
  }
}

}  // namespace rfm
