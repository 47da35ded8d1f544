#include "problems/region_choice.hpp"

#include <functional>
#include <numbers>

#include "core/boundary_part.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"
#include "core/neighbourhood.hpp"
#include "problems/stl_reader.hpp"

namespace rfm {
namespace {

using Choice = std::function<BoundaryPart(int primitive, const RegionEvaluator& region)>;

void choose(const Region& domain, const Choice& part_of, BoundaryTarget& target) {
  const RegionEvaluator region(domain);
  for (int k = 0; k < region.primitive_count(); ++k) {
    const Primitive& primitive = *domain.primitives()[k];
    if (primitive.selects_only) continue;
    const BoundaryPart part = part_of(k, region);
    if (part.extent == BoundaryPart::Extent::none) continue;
    target.pieces.push_back(primitive.name);
    if (part.extent == BoundaryPart::Extent::all) continue;
    target.parts.emplace(primitive.name, part.where);
    if (!part.ends.empty()) target.ends.push_back({part.ends});
  }
}

void refuse_empty(const BoundaryTarget& region, const DocumentNode& node, ValueReader& values) {
  if (region.pieces.empty())
    values.mistakes.add("the region '" + region.name + "' is empty: no part of the boundary " +
                            (node.is_list() ? "has this normal" : "touches '" + node.text + "'"),
                        node.place);
}

// What lies within a distance of a point, a set or the triangles of an STL file.
std::optional<Neighbourhood> read_neighbourhood(const DocumentNode& near, double distance,
                                                ValueReader& values, ShapeReader& shapes,
                                                const std::string& folder) {
  if (near.is_list()) {
    const auto point = values.point(near);
    return point ? std::optional(neighbourhood(point_set(*point, values.dimension), distance))
                 : std::nullopt;
  }
  return values.guarded<Neighbourhood>(near, [&] {
    if (const ThinSet* set = shapes.set(near.text)) {
      try {
        return neighbourhood(*set, distance);
      } catch (const InvalidArgument& error) {
        throw InputError(error.what(), 0, near.text.size());
      }
    }
    if (near.text.find('.') == std::string::npos)
      throw InputError("unknown set '" + near.text + "'" +
                           did_you_mean(near.text, shapes.set_names()) +
                           "; expected a point, a set or an STL file",
                       0, near.text.size());
    if (values.dimension < 3)
      throw InputError("an STL file is a surface in space", 0, near.text.size());
    return neighbourhood(read_stl(folder, near.text), distance);
  });
}

}  // namespace

void read_chosen_by_geometry(const DocumentNode& map, ValueReader& values, ShapeReader& shapes,
                             const std::string& folder, BoundaryTarget& region) {
  region.chosen_by_geometry = true;
  const std::optional<Region>& domain = shapes.domain();
  if (const DocumentNode* touching = values.find(map, "touching")) {
    const auto shape = values.guarded<Region>(*touching, [&] {
      return shapes.shape({touching->text, 0});
    });
    if (!shape || !domain) return;
    choose(
        *domain, [&](int k, const RegionEvaluator& all) { return part_touching(k, all, *shape); },
        region);
    refuse_empty(region, *touching, values);
  }
  if (const DocumentNode* near = values.find(map, "near")) {
    const DocumentNode* within = values.find(map, "within");
    const std::optional<double> distance = within ? values.number(*within) : std::nullopt;
    // Where no distance is given what is near is read all the same: all mistakes are told at once.
    const auto around = read_neighbourhood(*near, distance.value_or(1), values, shapes, folder);
    if (!distance || !around || !domain) return;
    choose(
        *domain,
        [&](int, const RegionEvaluator&) {
          return BoundaryPart{BoundaryPart::Extent::some, around->where, {}};
        },
        region);
    region.ends.push_back(around->ends);
  }
  if (const DocumentNode* normal = values.find(map, "normal")) {
    const std::optional<Point> direction = values.point(*normal);
    const DocumentNode* within = values.find(map, "within");
    if (!within) return;
    const std::optional<double> angle = values.number(*within);
    if (!direction || !angle || !domain) return;
    if (*direction == Point{})
      return values.mistakes.add("a normal of length 0 has no direction", normal->place);
    if (*angle >= 180)
      return values.mistakes.add("expected an angle below 180 degrees", within->place);
    choose(
        *domain,
        [&](int k, const RegionEvaluator& all) {
          return part_with_normal(k, all, *direction, *angle * std::numbers::pi / 180);
        },
        region);
    refuse_empty(region, *normal, values);
  }
}

}  // namespace rfm
