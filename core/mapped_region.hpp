#pragma once

#include <functional>
#include <optional>

#include "core/region.hpp"

namespace rfm {

/// What a primitive becomes: a region, or everything (true) or nothing (false).
struct MappedPrimitive {
  MappedPrimitive(Region region) : region(std::move(region)) {}  // NOLINT: a region is one
  explicit MappedPrimitive(bool everything) : everything(everything) {}
  std::optional<Region> region;
  bool everything = false;
};

/// The Boolean expression of a region with every primitive replaced by what `image` makes of it,
/// once each. Throws `InvalidArgument` if everything or nothing is left.
Region mapped_region(const Region& region,
                     const std::function<MappedPrimitive(const Primitive&)>& image);

/// A similarity x → about + scale · R (x − about) + translation: the rotation R turns by `angle`
/// (radians) about `axis` (in the plane about z).
struct Similarity {
  double scale = 1;
  double angle = 0;
  Point axis{0, 0, 1};
  Point translation{};
  Point about{};
};

/// The image of a region. Names stay; functions stay normalised, since their arguments are moved
/// back and their values scaled. Throws `InvalidArgument` unless scale > 0 and the axis has a
/// direction (along z in the plane).
Region transformed(const Region& region, const Similarity& similarity);

}  // namespace rfm
