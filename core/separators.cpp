#include "core/separators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/boundary_part.hpp"
#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/normalization_length.hpp"
#include "core/piece_loops.hpp"
#include "core/piece_points.hpp"
#include "core/polygon.hpp"
#include "core/quadric.hpp"
#include "core/surroundings.hpp"
#include "core/tape.hpp"
#include "core/winding_sign.hpp"

namespace rfm {
namespace {

struct Separator {
  Field function;
  std::string text;
};

// What separates a piece from the rest of its curve or surface; nothing for those on lines and
// planes, which need none.
std::vector<Separator> separators_of(const ThinSet& piece, const std::string& name) {
  const std::optional<Quadric> quadric = as_quadric(*piece.surface, piece.dimension);
  if (quadric && quadric->is_affine()) return {};
  std::vector<Separator> list;
  for (const Field& end : piece.ends)
    list.push_back({end, piece.points.size() == 2 ? "the chord of " + name
                                                  : "what trims " + name + " at its ends"});
  return list;
}

// Pieces may end on one line, or on the curve of another piece.
bool is_new(const Separator& separator, const std::vector<Field>& functions,
            const std::vector<Separator>& others, int dimension) {
  const auto is_other = [&](const Field& function) {
    return !same_surface(function, separator.function, dimension);
  };
  return std::ranges::all_of(functions, is_other) &&
         std::ranges::all_of(others, is_other, &Separator::function);
}

Box box_of(const std::vector<ThinSet>& pieces) {
  constexpr double infinite = std::numeric_limits<double>::infinity();
  const int dimension = pieces[0].dimension;
  Box box{dimension, {}, {}};
  for (int axis = 0; axis < dimension; ++axis) box.low[axis] = infinite, box.high[axis] = -infinite;
  const auto add = [&](const Point& point) {
    for (int axis = 0; axis < dimension; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  };
  if (dimension == 3) {
    for (const ThinSet& piece : pieces)
      for (const Point& point : piece.points) add(point);
    return box;
  }
  for (const auto& loop : closed_loops(pieces))
    for (const LoopPiece& piece : loop) {
      const Point &a = piece.from, &b = piece.to;
      // An arc lies within its chord's length times (1 + b²)/2|b| of its ends.
      const double reach = piece.bulge == 0
                               ? 0
                               : std::hypot(b[0] - a[0], b[1] - a[1]) *
                                     (1 + piece.bulge * piece.bulge) / (2 * std::fabs(piece.bulge));
      for (const Point& end : {a, b}) {
        add({end[0] - reach, end[1] - reach});
        add({end[0] + reach, end[1] + reach});
      }
    }
  return box;
}

// Whether the pieces are straight and their loops do not meet: then they are a polygon, each edge
// of which occurs once in its expression, so that its function has slope 1 on all edges.
std::optional<DescribedSolid> as_polygon(const std::vector<ThinSet>& pieces,
                                         const std::vector<std::string>& names) {
  std::vector<Contour> contours;
  std::vector<Segment> segments;
  std::vector<int> next;
  for (const auto& loop : closed_loops(pieces)) {
    Contour& contour = contours.emplace_back();
    const int first = static_cast<int>(segments.size()), count = static_cast<int>(loop.size());
    for (int i = 0; i < count; ++i) {
      if (loop[i].bulge != 0) return std::nullopt;
      contour.points.push_back(loop[i].from);
      contour.names.push_back(names[loop[i].piece]);
      segments.push_back({loop[i].from, loop[(i + 1) % count].from});
      next.push_back(first + (i + 1) % count);
    }
  }
  if (intersecting_pair(segments, next)) return std::nullopt;
  Outline outline = polygon(contours);
  return DescribedSolid{std::move(outline.region), std::move(outline.sides), {}, 0, {}, {}};
}

// Cells are sampled: time grows with the square of the number of pieces, in space with the cube.
constexpr std::size_t most_pieces = 64;

// Points of pieces that do not bound the solid: a cell next to them was lost, or they are no
// boundary.
void require_pieces_to_bound(const Region& solid, const std::vector<std::vector<Point>>& points,
                             const std::vector<std::string>& names, double size, bool everywhere) {
  const RegionEvaluator region(solid);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::optional<Point> astray;
    int bounding = 0;
    for (const Point& point : points[i]) {
      const Surroundings around =
          surroundings(region, point, 1e-12 * size, 1e-3 * extent_of(points[i]));
      if (around.any_inside && around.any_outside)
        ++bounding;
      else
        astray = point;
    }
    if (everywhere ? !astray : bounding > 0) continue;
    throw InvalidArgument(
        "'" + names[i] + "' does not bound what the pieces describe" +
        (astray ? ": both sides of " + point_text(*astray, solid.dimension()) + " are the same"
                : ": it has no points"));
  }
}

DescribedSolid described_by_signs(const std::vector<ThinSet>& pieces,
                                  const std::vector<std::string>& names,
                                  const Membership& membership, const Box& bounds,
                                  bool everywhere) {
  if (pieces.size() > most_pieces)
    throw InvalidArgument("a boundary of " + std::to_string(pieces.size()) +
                          " pieces that is no simple polygon: at most " +
                          std::to_string(most_pieces) + " can be described");
  const int dimension = bounds.dimension;
  std::vector<Field> functions;
  std::vector<std::vector<std::size_t>> members;  // the pieces on each curve
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (!pieces[i].surface)
      throw InvalidArgument("a piece of the boundary of a solid has a surface");
    const Field& surface = *pieces[i].surface;
    const auto known = std::ranges::find_if(
        functions, [&](const Field& other) { return same_surface(other, surface, dimension); });
    members.resize(std::max(members.size(), std::size_t(known - functions.begin()) + 1));
    members[known - functions.begin()].push_back(i);
    if (known == functions.end()) functions.push_back(surface);
  }
  const int own = static_cast<int>(functions.size());
  std::vector<std::vector<Point>> points;
  for (const ThinSet& piece : pieces) points.push_back(points_on(piece, bounds));
  SetDescription description(functions, membership, bounds, points);
  const std::optional<std::pair<Point, Point>> conflict = description.conflict();
  std::vector<Separator> candidates;
  if (conflict) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (Separator& separator : separators_of(pieces[i], names[i]))
        if (is_new(separator, functions, candidates, dimension))
          candidates.push_back(std::move(separator));
    std::vector<Field> all = functions;
    for (const Separator& separator : candidates) all.push_back(separator.function);
    description = SetDescription(all, membership, bounds, points);
  }
  const std::vector<bool> used = without_needless_separators(description, own);
  const BooleanExpression expression = description.restricted(used).minimal_form();

  std::vector<std::shared_ptr<const Primitive>> primitives;
  std::vector<OutlineSide> sides;
  for (int i = 0; i < own; ++i) {
    std::string name = names[members[i][0]];
    if (members[i].size() > 1) name += "_line";
    for (const std::size_t piece : members[i])
      if (members[i].size() > 1) sides.push_back({names[piece], {name}, pieces[piece].where});
    primitives.push_back(std::make_shared<const Primitive>(Primitive{
        name, normalize_by_itself(functions[i], dimension, bounds.longest_side()), functions[i]}));
  }
  std::vector<std::string> needed, needless;
  std::vector<int> number(static_cast<std::size_t>(own) + candidates.size(), 0);
  for (int i = 0; i < own; ++i) number[i] = i;
  for (std::size_t i = 0; i < candidates.size(); ++i) {
    const Separator& separator = candidates[i];
    (used[own + i] ? needed : needless).push_back(separator.text);
    if (!used[own + i]) continue;
    number[own + i] = static_cast<int>(primitives.size());
    primitives.push_back(std::make_shared<const Primitive>(
        Primitive{"separator" + std::to_string(needed.size()),
                  normalize_by_itself(separator.function, dimension, bounds.longest_side()),
                  separator.function, true}));
  }
  Region region(dimension, std::move(primitives), expression.renamed(number));
  require_pieces_to_bound(region, points, names, bounds.longest_side(), everywhere);
  return {std::move(region), std::move(sides),   conflict, static_cast<int>(candidates.size()),
          std::move(needed), std::move(needless)};
}

void require_names(const std::vector<ThinSet>& pieces, const std::vector<std::string>& names) {
  if (pieces.empty() || names.size() != pieces.size())
    throw InvalidArgument("a solid has pieces of its boundary, each with a name");
}

}  // namespace

DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names, const Membership& membership,
                               const Box& bounds) {
  require_names(pieces, names);
  return described_by_signs(pieces, names, membership, bounds, false);
}

DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names) {
  require_names(pieces, names);
  const WindingSign winding(pieces);  // throws if they do not close
  if (pieces[0].dimension == 2)
    if (std::optional<DescribedSolid> polygon = as_polygon(pieces, names)) return *polygon;
  const Box bounds = box_of(pieces);
  const double near = 1e-9 * bounds.longest_side();
  std::vector<Field> functions;
  for (const ThinSet& piece : pieces) functions.push_back(piece.function);
  const Tape distances(functions, {0}, bounds.dimension);
  const Membership membership = [&](const Point& point) {
    for (std::size_t i = 0; i < pieces.size(); ++i)  // on a piece neither
      if (distances.value(point, static_cast<int>(i)) <= near) return Truth::unknown;
    return winding.is_inside(point) ? Truth::yes : Truth::no;
  };
  DescribedSolid solid = described_by_signs(pieces, names, membership, bounds, true);
  solid.region = solid.region.within(bounds);
  return solid;
}

}  // namespace rfm
