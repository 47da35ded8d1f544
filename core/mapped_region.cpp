#include "core/mapped_region.hpp"

#include <cmath>
#include <vector>

#include "core/composition.hpp"
#include "core/error.hpp"

namespace rfm {
namespace {

using Kind = BooleanExpression::Kind;

MappedPrimitive negated(const MappedPrimitive& a) {
  return a.region ? MappedPrimitive(!*a.region) : MappedPrimitive(!a.everything);
}

// a & b, or a | b where `absorbing` (everything) decides.
MappedPrimitive joined(const MappedPrimitive& a, const MappedPrimitive& b, bool conjunction) {
  if (a.region && b.region) return conjunction ? *a.region & *b.region : *a.region | *b.region;
  const MappedPrimitive& constant = a.region ? b : a;
  const MappedPrimitive& other = a.region ? a : b;
  return constant.everything == conjunction ? other : constant;
}

// eᵢ turned by Rodrigues' formula.
Point turned(int i, const Point& axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle), along = axis[i] * (1 - c);
  Point e{};
  e[i] = 1;
  const Point cross{axis[1] * e[2] - axis[2] * e[1], axis[2] * e[0] - axis[0] * e[2],
                    axis[0] * e[1] - axis[1] * e[0]};
  Point result;
  for (int k = 0; k < 3; ++k) result[k] = c * e[k] + s * cross[k] + along * axis[k];
  return result;
}

// The box around the image of a box: the sides of the image are those of the turned edges.
Box moved_box(const Box& box, const Similarity& similarity, const Point& direction) {
  Point center{}, reach{};
  for (int k = 0; k < box.dimension; ++k) {
    const Point e = turned(k, direction, similarity.angle);
    const double offset = 0.5 * (box.low[k] + box.high[k]) - similarity.about[k];
    for (int i = 0; i < box.dimension; ++i) {
      center[i] += similarity.scale * e[i] * offset;
      reach[i] += 0.5 * similarity.scale * std::fabs(e[i]) * box.length(k);
    }
  }
  Box image = box;
  for (int i = 0; i < box.dimension; ++i) {
    const double middle = similarity.about[i] + similarity.translation[i] + center[i];
    image.low[i] = middle - reach[i];
    image.high[i] = middle + reach[i];
  }
  return image;
}

}  // namespace

Region mapped_region(const Region& region,
                     const std::function<MappedPrimitive(const Primitive&)>& image) {
  std::vector<MappedPrimitive> primitives, nodes;
  for (const auto& primitive : region.primitives()) primitives.push_back(image(*primitive));
  for (const auto& node : region.expression().nodes()) {
    switch (node.kind) {
      case Kind::constant:
        nodes.push_back(MappedPrimitive(node.first != 0));
        break;
      case Kind::variable:
        nodes.push_back(primitives[node.first]);
        break;
      case Kind::negation:
        nodes.push_back(negated(nodes[node.first]));
        break;
      case Kind::conjunction:
      case Kind::disjunction:
        nodes.push_back(
            joined(nodes[node.first], nodes[node.second], node.kind == Kind::conjunction));
        break;
    }
  }
  const MappedPrimitive& whole = nodes.back();
  if (!whole.region)
    throw InvalidArgument(whole.everything ? "the region is all of space" : "the region is empty");
  return *whole.region;
}

Region transformed(const Region& region, const Similarity& similarity) {
  if (!(similarity.scale > 0)) throw InvalidArgument("the scale of a shape must be positive");
  const Point& axis = similarity.axis;
  const double length = std::hypot(axis[0], axis[1], axis[2]);
  const int dimension = region.dimension();
  if (!(length > 0)) throw InvalidArgument("an axis of length 0 has no direction");
  if (dimension < 3 && (axis[0] != 0 || axis[1] != 0))
    throw InvalidArgument("in the plane shapes turn about z");
  const Point direction{axis[0] / length, axis[1] / length, axis[2] / length};
  // The inverse: coordinate i is that of the point moved back, along the turned axis i.
  std::vector<Field> map;
  for (int i = 0; i < dimension; ++i) {
    const Point e = similarity.angle == 0
                        ? Point{i == 0 ? 1.0 : 0, i == 1 ? 1.0 : 0, i == 2 ? 1.0 : 0}
                        : turned(i, direction, similarity.angle);
    Field back = similarity.about[i];
    for (int k = 0; k < dimension; ++k)
      back = back + e[k] / similarity.scale *
                        (coordinate(k) - (similarity.about[k] + similarity.translation[k]));
    map.push_back(back);
  }
  const Region image = mapped_region(region, [&](const Primitive& primitive) {
    Primitive moved = primitive;
    const bool same = primitive.function.same_as(primitive.level);
    moved.function = similarity.scale * compose(primitive.function, map);
    moved.level = same ? moved.function : compose(primitive.level, map);
    return MappedPrimitive(Region(std::move(moved), dimension));
  });
  return region.enclosure() ? image.within(moved_box(*region.enclosure(), similarity, direction))
                            : image;
}

}  // namespace rfm
