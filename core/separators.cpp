#include "core/separators.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/boundary_part.hpp"
#include "core/error.hpp"
#include "core/quadric.hpp"
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
  const int dimension = pieces.empty() ? 2 : pieces[0].dimension;
  Box box{dimension, {}, {}};
  for (int axis = 0; axis < dimension; ++axis) box.low[axis] = infinite, box.high[axis] = -infinite;
  const auto add = [&](const Point& point) {
    for (int axis = 0; axis < dimension; ++axis) {
      box.low[axis] = std::min(box.low[axis], point[axis]);
      box.high[axis] = std::max(box.high[axis], point[axis]);
    }
  };
  for (const ThinSet& piece : pieces) {
    for (const Point& point : piece.points) add(point);
    if (piece.bulge == 0 || piece.points.size() != 2) continue;
    // An arc lies within its chord's length times (1 + b²)/2|b| of its ends.
    const Point &a = piece.points[0], &b = piece.points[1];
    const double reach = std::hypot(b[0] - a[0], b[1] - a[1]) * (1 + piece.bulge * piece.bulge) /
                         (2 * std::fabs(piece.bulge));
    for (const Point& end : piece.points) {
      add({end[0] - reach, end[1] - reach});
      add({end[0] + reach, end[1] + reach});
    }
  }
  return box;
}

}  // namespace

DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names, const Membership& membership,
                               const Box& bounds) {
  if (pieces.empty() || names.size() != pieces.size())
    throw InvalidArgument("a solid has pieces of its boundary, each with a name");
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
  SetDescription description(functions, membership, bounds);
  const std::optional<std::pair<Point, Point>> conflict = description.conflict();
  std::vector<Separator> candidates;
  if (conflict) {
    for (std::size_t i = 0; i < pieces.size(); ++i)
      for (Separator& separator : separators_of(pieces[i], names[i]))
        if (is_new(separator, functions, candidates, dimension))
          candidates.push_back(std::move(separator));
    std::vector<Field> all = functions;
    for (const Separator& separator : candidates) all.push_back(separator.function);
    description = SetDescription(all, membership, bounds);
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
    primitives.push_back(std::make_shared<const Primitive>(
        Primitive{name, normalize(functions[i], dimension), functions[i]}));
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
                  normalize(separator.function, dimension), separator.function, true}));
  }
  return {Region(dimension, std::move(primitives), expression.renamed(number)),
          std::move(sides),
          conflict,
          static_cast<int>(candidates.size()),
          std::move(needed),
          std::move(needless)};
}

DescribedSolid described_solid(const std::vector<ThinSet>& pieces,
                               const std::vector<std::string>& names) {
  const WindingSign winding(pieces);
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
  DescribedSolid solid = described_solid(pieces, names, membership, bounds);
  solid.region = solid.region.within(bounds);
  return solid;
}

}  // namespace rfm
