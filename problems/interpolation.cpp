#include "problems/interpolation.hpp"

#include <algorithm>
#include <functional>

#include "core/boundary_piece.hpp"
#include "core/bounding_box.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/normalization_length.hpp"
#include "core/r_functions.hpp"
#include "core/tape.hpp"
#include "core/trim.hpp"

namespace rfm {
namespace {

bool bounds_domain(const std::string& piece, const std::optional<Region>& domain) {
  return domain && std::ranges::any_of(domain->primitives(), [&](const auto& primitive) {
           return primitive->name == piece;
         });
}

// 0 in the region, its distance outside to first order.
Field distance_outside(const Region& region) {
  const Field omega = implicit(region);
  return select(step(omega), 0.0, -omega);
}

// What an entry says beside its places.
class DatumReader {
 public:
  DatumReader(const InterpolationPlaces& places, const ExpressionScope& scope,
              const std::optional<Box>& bounds = {})
      : places_(places), scope_(scope), bounds_(bounds) {}

  /// Adds the data of one entry, whose places are sets and inner shapes, or sides.
  void read(const DocumentNode& item, const std::function<void(InterpolationDatum)>& add) {
    const DocumentNode* at = item.find("at");
    if (!at) return;
    std::vector<const DocumentNode*> names;
    if (at->is_scalar()) names.push_back(at);
    for (const DocumentNode& name : at->items) names.push_back(&name);
    const SetData given = data(item);
    // Where several sets with one value meet the interpolant stays defined if they are one.
    const bool is_one = given.derivatives.empty() && names.size() > 1;
    std::optional<InterpolationDatum> all;
    for (const DocumentNode* name : names)
      for (InterpolationDatum& datum : places_of(*name, given)) {
        if (!is_one) {
          add(std::move(datum));
        } else if (!all) {
          all = std::move(datum);
        } else {
          all->data.further_distances.push_back(datum.data.distance);
          all->name += ", " + datum.name;
        }
      }
    if (all) add(std::move(*all));
  }

  const std::vector<Mistake>& mistakes() const { return mistakes_; }
  const Box& bounds() {
    if (!bounds_) bounds_ = bounding_box(region());
    return *bounds_;
  }

 private:
  SetData data(const DocumentNode& item) {
    SetData result;
    if (const DocumentNode* value = item.find("value")) result.value = field(unmapped(*value));
    for (const char* key : {"normal_derivative", "second_normal_derivative"})
      if (const DocumentNode* derivative = item.find(key))
        result.derivatives.push_back(field(*derivative));
    if (const DocumentNode* exponent = item.find("exponent"))
      result.exponent = static_cast<int>(to_number(Expression(exponent->text), scope_));
    return result;
  }

  // {u: value} of the only unknown.
  static const DocumentNode& unmapped(const DocumentNode& value) {
    return value.is_map() && value.entries.size() == 1 ? value.entries[0].value : value;
  }

  Field field(const DocumentNode& node) {
    try {
      return to_field(Expression(node.text), scope_);
    } catch (const InputError& mistake) {
      mistakes_.push_back({mistake.what(), node.place_within(mistake.offset, mistake.length)});
      return 0.0;
    }
  }

  std::vector<InterpolationDatum> places_of(const DocumentNode& name, const SetData& given) {
    InterpolationDatum datum{name.text, given, {}, {}, name.place};
    if (const auto set = places_.sets.find(name.text); set != places_.sets.end()) {
      datum.data.distance = set->second.function;
      // Those of formulas are as they are written.
      if (set->second.surface)
        datum.data.side = normalize_by_itself(*set->second.surface, places_.dimension);
      datum.surface = set->second.surface;
      return with_normal(std::move(datum), "only curves of the plane and surfaces of space");
    }
    if (is_inner_shape(name.text, places_.shapes, places_.domain)) {
      datum.region = places_.shapes.at(name.text);
      datum.data.distance = distance_outside(*datum.region);
      return with_normal(std::move(datum), "it is all of a shape inside the domain; only sets");
    }
    return sides_of(name, given);
  }

  std::vector<InterpolationDatum> with_normal(InterpolationDatum datum, const std::string& only) {
    if (!datum.data.derivatives.empty() && !datum.data.side) {
      mistakes_.push_back(
          {"'" + datum.name + "' has no normal: " + only + " have one", datum.place});
      return {};
    }
    std::vector<InterpolationDatum> list;
    list.push_back(std::move(datum));
    return list;
  }

  // The pieces of a side, or of a shape that bounds the domain.
  std::vector<InterpolationDatum> sides_of(const DocumentNode& name, const SetData& given) {
    std::vector<InterpolationDatum> list;
    const auto shape = places_.shapes.find(name.text);
    for (int k = 0; places_.domain && k < region().primitive_count(); ++k) {
      const Primitive& primitive = *places_.domain->primitives()[k];
      const bool is_of_shape =
          shape != places_.shapes.end() &&
          std::ranges::any_of(shape->second.primitives(),
                              [&](const auto& own) { return own->name == primitive.name; });
      if (primitive.selects_only || (primitive.name != name.text && !is_of_shape)) continue;
      const BoundaryPiece piece = boundary_piece(k, region(), bounds());
      InterpolationDatum datum{primitive.name, given, {}, {}, name.place};
      datum.data.distance = piece.from_inside;
      datum.data.side = -outward_sign(k, region()) * primitive.function;
      list.push_back(std::move(datum));
    }
    if (list.empty() && places_.domain) {
      std::vector<std::string> known;
      for (const auto& [set, meaning] : places_.sets) known.push_back(set);
      for (const auto& [other, meaning] : places_.shapes) known.push_back(other);
      for (const auto& primitive : places_.domain->primitives()) known.push_back(primitive->name);
      mistakes_.push_back({"'" + name.text + "' is no set, shape or side of a shape" +
                               did_you_mean(name.text, known),
                           name.place});
    }
    return list;
  }

  const RegionEvaluator& region() {
    if (!region_) region_.emplace(*places_.domain);
    return *region_;
  }

  const InterpolationPlaces& places_;
  const ExpressionScope& scope_;
  std::optional<Box> bounds_;
  std::optional<RegionEvaluator> region_;
  std::vector<Mistake> mistakes_;
};

SetData piece_data(const PieceCondition& condition, const RegionEvaluator& region,
                   const Box& bounds) {
  const BoundaryPiece piece = boundary_piece(condition.primitive, region, bounds);
  SetData data;
  data.distance = condition.where ? trim(piece.function, *condition.where, bounds.longest_side())
                                  : piece.from_inside;
  if (condition.kind == Condition::Kind::value) data.value = condition.data[0];
  data.derivatives.assign(condition.data.begin() + (data.value ? 1 : 0), condition.data.end());
  data.side = -outward_sign(condition.primitive, region) *
              region.region().primitives()[condition.primitive]->function;
  data.exponent = condition.exponent;
  return data;
}

// Pieces on which one formula is given, and no derivatives, are one set: where they meet the
// interpolant is defined.
bool are_one(const SetData& a, const SetData& b) {
  return a.value && b.value && a.derivatives.empty() && b.derivatives.empty() &&
         a.exponent == b.exponent && same_expression(*a.value, *b.value);
}

}  // namespace

bool is_inner_shape(const std::string& name, const std::map<std::string, Region>& shapes,
                    const std::optional<Region>& domain) {
  const auto shape = shapes.find(name);
  return shape != shapes.end() &&
         std::ranges::none_of(shape->second.primitives(), [&](const auto& primitive) {
           return bounds_domain(primitive->name, domain);
         });
}

bool check_interpolation_entry(const DocumentNode& item, ValueReader& values) {
  bool is_right = true;
  const auto refuse = [&](const std::string& message, const Place& place) {
    values.mistakes.add(message, place);
    is_right = false;
  };
  const DocumentNode *value = item.find("value"), *first = item.find("normal_derivative"),
                     *second = item.find("second_normal_derivative");
  if (second && !(value && first))
    refuse("a second normal derivative needs a value and a first one beside it", second->place);
  const int order = second ? 2 : first ? 1 : 0;
  const DocumentNode* exponent = values.find(item, "exponent");
  if (const auto number = exponent ? values.integer(*exponent) : std::nullopt;
      number && *number <= order)
    refuse("derivatives of order " + std::to_string(order) + " need an exponent of " +
               std::to_string(order + 1) + " at least",
           exponent->place);
  return is_right;
}

void check_interpolation_file(const DocumentNode& root, ValueReader& values) {
  const auto refuse = [&](const DocumentNode* node, const std::string& key) {
    if (node)
      values.mistakes.add("an interpolant solves no equation: '" + key + "' means nothing for it",
                          node->place);
  };
  for (const char* key : {"enrich", "remainder", "windows"}) refuse(values.find(root, key), key);
  if (const DocumentNode* discretization = values.find(root, "discretization"))
    refuse(values.find(*discretization, "structure"), "structure");
  if (const DocumentNode* physics = values.find(root, "physics"))
    refuse(values.find(*physics, "materials"), "materials");
  const DocumentNode* study = values.find(root, "study");
  const DocumentNode* type = study ? values.find(*study, "type") : nullptr;
  if (type && type->text != "steady") refuse(type, type->text);
}

std::vector<InterpolationDatum> inner_interpolation_data(const Problem& problem) {
  const InterpolationPlaces places{problem.sets, problem.shapes, problem.domain, problem.dimension};
  DatumReader reader(places, problem.scope);
  std::vector<InterpolationDatum> list;
  const DocumentNode* conditions = problem.document.find("conditions");
  for (const DocumentNode& item : conditions->items) {
    const DocumentNode* at = item.find("at");
    const std::string& first = at->is_scalar() ? at->text : at->items.at(0).text;
    if (problem.sets.contains(first) || is_inner_shape(first, problem.shapes, problem.domain))
      reader.read(item, [&](InterpolationDatum datum) { list.push_back(std::move(datum)); });
  }
  if (!reader.mistakes().empty()) throw ProblemFileErrors(reader.mistakes());
  return list;
}

Interpolation interpolation(const Problem& problem, const std::vector<PieceCondition>& conditions,
                            const RegionEvaluator& region, const Box& bounds) {
  std::vector<SetData> sets;
  for (const PieceCondition& condition : conditions) {
    const SetData data = piece_data(condition, region, bounds);
    const auto same =
        std::ranges::find_if(sets, [&](const SetData& other) { return are_one(other, data); });
    if (same != sets.end()) {
      same->further_distances.push_back(data.distance);
      continue;
    }
    sets.push_back(data);
  }
  for (const InterpolationDatum& datum : inner_interpolation_data(problem))
    sets.push_back(datum.data);
  try {
    return {interpolated(sets, bounds.longest_side(), problem.dimension),
            static_cast<int>(sets.size())};
  } catch (const InvalidArgument& mistake) {
    throw ProblemFileErrors({Mistake{mistake.what(), problem.conditions_place}});
  }
}

std::optional<Field> interpolated_coefficient(const DocumentNode& list,
                                              const InterpolationPlaces& places,
                                              const std::optional<Box>& bounds,
                                              const ExpressionScope& scope, ValueReader& values) {
  if (!places.domain) return std::nullopt;  // its mistake is reported
  DatumReader reader(places, scope, bounds);
  std::vector<SetData> sets;
  try {
    for (const DocumentNode& item : list.items)
      if (values.fits(item))
        reader.read(item, [&](const InterpolationDatum& datum) { sets.push_back(datum.data); });
    for (const Mistake& mistake : reader.mistakes())
      values.mistakes.add(mistake.message, mistake.place);
    if (!reader.mistakes().empty()) return std::nullopt;
    return interpolated(sets, reader.bounds().longest_side(), places.dimension).inhomogeneous();
  } catch (const InvalidArgument& mistake) {
    values.mistakes.add(mistake.what(), list.place);
    return std::nullopt;
  }
}

}  // namespace rfm
