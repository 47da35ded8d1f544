#include "problems/structure_options.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

class OptionsReader {
 public:
  explicit OptionsReader(const Problem& problem) : problem_(problem) {
    const bool interpolates = problem.physics.type == PhysicsType::interpolation;
    if (const DocumentNode* conditions = problem.document.find("conditions");
        conditions && !interpolates)  // interpolation.hpp reads those
      for (const DocumentNode& item : conditions->items) read_condition(item);
    if (const DocumentNode* enrich = problem.document.find("enrich"))
      for (const DocumentNode& item : enrich->items) read_enrichment(item);
    if (const DocumentNode* windows = problem.document.find("windows"))
      for (const DocumentNode& item : windows->items) read_window(item);
    if (!mistakes_.empty()) throw ProblemFileErrors(mistakes_);
  }

  const StructureOptions& options() const { return options_; }

 private:
  void add(const std::string& message, const Place& place) {
    mistakes_.push_back(Mistake{message, place});
  }

  Field field(const DocumentNode& node) {
    try {
      return to_field(Expression(node.text), problem_.scope);
    } catch (const InputError& mistake) {
      add(mistake.what(), node.place_within(mistake.offset, mistake.length));
      return 0.0;
    }
  }
  double number(const DocumentNode& node) {
    try {
      return to_number(Expression(node.text), problem_.scope);
    } catch (const InputError& mistake) {
      add(mistake.what(), node.place_within(mistake.offset, mistake.length));
      return 0;
    }
  }

  void read_condition(const DocumentNode& item) {
    const DocumentNode* at = item.find("at");
    if (!at) return;
    std::vector<const DocumentNode*> names;
    if (at->is_scalar()) names.push_back(at);
    for (const DocumentNode& name : at->items) names.push_back(&name);
    const DocumentNode* interface = item.find("interface");
    for (const DocumentNode* name : names) {
      if (interface)
        read_interface(*name, *interface);
      else if (const auto set = problem_.sets.find(name->text); set != problem_.sets.end())
        read_set_value(set->first, set->second, item, *name);
    }
  }

  void read_interface(const DocumentNode& name, const DocumentNode& map) {
    const auto shape = problem_.shapes.find(name.text);
    if (shape == problem_.shapes.end())
      return add("'" + name.text + "' is no shape: an interface is the boundary of one",
                 name.place);
    DocumentNode omega = name;
    omega.text = "omega(" + name.text + ")";
    Field jump = 0.0;
    if (const DocumentNode* value = map.find("jump")) jump = field(*value);
    options_.interfaces.push_back({name.text, shape->second, field(omega), jump, name.place});
  }

  void read_set_value(const std::string& name, const ThinSet& set, const DocumentNode& item,
                      const DocumentNode& at) {
    const DocumentNode* value = item.find("value");
    if (!value) return add("on a set only a value can be prescribed", at.place);
    if (const DocumentNode* enforce = item.find("enforce"); enforce && enforce->text == "weak")
      return add("a value on a set can be enforced by structure only", enforce->place);
    const std::vector<std::string>& unknowns = problem_.physics.unknowns;
    for (const SetValue& earlier : options_.values)
      if (earlier.set == name) return add("'" + name + "' has a value already", at.place);
    if (!value->is_map()) {
      if (unknowns.size() > 1)
        return add("there are several unknowns: expected {" + unknowns[0] + ": .., " + unknowns[1] +
                       ": ..}; those left out are free",
                   value->place);
      options_.values.push_back({name, 0, set, field(*value), at.place});
      return;
    }
    for (const DocumentNode::Entry& entry : value->entries) {
      const auto unknown = std::ranges::find(unknowns, entry.key);
      if (unknown == unknowns.end())
        add("unknown result '" + entry.key + "' in value" + did_you_mean(entry.key, unknowns),
            entry.key_place);
      else
        options_.values.push_back({name, static_cast<int>(unknown - unknowns.begin()), set,
                                   field(entry.value), at.place});
    }
  }

  void read_enrichment(const DocumentNode& item) {
    Enrichment result;
    result.place = item.place;
    const DocumentNode* at = item.find("at");
    if (!at) return;
    if (problem_.dimension != 2)
      return add("singular functions are those of corners in the plane", item.place);
    if (at->is_list()) {
      for (std::size_t axis = 0; axis < at->items.size() && axis < 2; ++axis)
        result.at[axis] = number(at->items[axis]);
    } else if (const auto set = problem_.sets.find(at->text);
               set != problem_.sets.end() && set->second.points.size() == 1) {
      result.at = set->second.points[0];
    } else {
      return add("expected a point [x, y], or the name of a set that is a point", at->place);
    }
    if (const DocumentNode* exponents = item.find("exponents"))
      for (const DocumentNode& exponent : exponents->items) {
        result.exponents.push_back(number(exponent));
        if (!(result.exponents.back() > 0))
          add("an exponent of the distance must be positive", exponent.place);
      }
    options_.enrichments.push_back(std::move(result));
  }

  void read_window(const DocumentNode& item) {
    const DocumentNode *in = item.find("in"), *basis = item.find("basis");
    if (!in || !basis || !basis->find("cells")) return;
    const auto shape = problem_.shapes.find(in->text);
    if (shape == problem_.shapes.end())
      return add("'" + in->text + "' is no shape: a window is the inside of one", in->place);
    for (const auto& own : shape->second.primitives())
      for (const auto& other : problem_.domain->primitives())
        if (own->name == other->name)
          return add("the domain is made of '" + own->name +
                         "': a window is a shape of its own, though it may be an equal one",
                     in->place);
    WindowOption window{in->text, shape->second, {}, 0, 0, true, in->place};
    if (const DocumentNode* degree = basis->find("bspline"))
      window.degree = static_cast<int>(number(*degree));
    window.cells = static_cast<int>(number(*basis->find("cells")));
    window.smoothness = static_cast<int>(number(*item.find("smoothness")));
    window.global = item.find("solve")->text == "global";
    options_.windows.push_back(std::move(window));
  }

  const Problem& problem_;
  StructureOptions options_;
  std::vector<Mistake> mistakes_;
};

}  // namespace

bool is_inner_condition(const DocumentNode& condition, const std::vector<std::string>& sets) {
  if (condition.find("interface")) return true;
  const DocumentNode* at = condition.find("at");
  if (!at) return false;
  const auto is_set = [&](const DocumentNode& name) {
    return std::ranges::find(sets, name.text) != sets.end();
  };
  return at->is_scalar() ? is_set(*at)
                         : !at->items.empty() && std::ranges::all_of(at->items, is_set);
}

StructureOptions structure_options(const Problem& problem) {
  return OptionsReader(problem).options();
}

}  // namespace rfm
