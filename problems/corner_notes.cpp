#include "problems/corner_notes.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <set>

#include "core/error.hpp"
#include "core/evaluate.hpp"
#include "core/smooth_joints.hpp"
#include "core/tape.hpp"
#include "quadrature/edges.hpp"
#include "quadrature/vertices.hpp"

namespace rfm {
namespace {

// A corner of the plane, or a place on an edge of space.
struct Meeting {
  Point point;
  int first, second;
  double angle;
};

std::vector<Meeting> meetings(const RegionEvaluator& region, const Box& bounds) {
  std::vector<Meeting> found;
  if (bounds.dimension == 2) {
    for (const Vertex& corner : find_vertices(region, bounds).vertices)
      for (std::size_t i = 0; i < corner.primitives.size(); ++i)
        for (std::size_t j = i + 1; j < corner.primitives.size(); ++j)
          found.push_back({corner.point, corner.primitives[i], corner.primitives[j], corner.angle});
  } else if (bounds.dimension == 3) {
    // Some points of each edge are enough.
    EdgeOptions options;
    options.points = 1;
    options.cells = 8;
    options.tolerance = std::numeric_limits<double>::infinity();
    const EdgePoints edges = make_edge_rule(region, bounds, options).points;
    for (int i = 0; i < edges.size(); ++i)
      found.push_back({edges.point(i), edges.first[i], edges.second[i], edges.angles[i]});
  }
  return found;
}

std::string text_of(const Point& point, int dimension) {
  return dimension > 2 ? fmt::format("({:.4g}, {:.4g}, {:.4g})", point[0], point[1], point[2])
                       : fmt::format("({:.4g}, {:.4g})", point[0], point[1]);
}

// Not a number where there is none, as of sampled data that end just before a corner.
double number_at(const Field& field, const Point& point) {
  try {
    return value_at(field, point);
  } catch (const ComputationError&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
}

// The whole piece of a primitive that has a value of this unknown.
const PieceCondition* value_of(const std::vector<PieceCondition>& conditions, int primitive,
                               int component) {
  for (const PieceCondition& piece : conditions)
    if (piece.primitive == primitive && piece.component == component && !piece.where &&
        piece.kind == Condition::Kind::value)
      return &piece;
  return nullptr;
}

class CornerNotes {
 public:
  CornerNotes(const RegionEvaluator& region, const Box& bounds)
      : dimension_(bounds.dimension),
        center_(bounds.center()),
        meetings_(meetings(region, bounds)) {}

  // Values that differ where they meet; and, if not, those of different formulas.
  void look_at_values(const std::vector<PieceCondition>& conditions, int component,
                      bool by_structure) {
    // How large values are; at a corner they may be rounding alone.
    double size = 0;
    for (const PieceCondition& piece : conditions)
      if (piece.component == component && piece.kind == Condition::Kind::value)
        if (const double value = std::fabs(number_at(piece.data[0], center_)); value > size)
          size = value;
    for (const Meeting& meeting : meetings_) {
      const PieceCondition* const a = value_of(conditions, meeting.first, component);
      const PieceCondition* const b = value_of(conditions, meeting.second, component);
      if (!a || !b || same_expression(a->data[0], b->data[0])) continue;
      const double of_a = number_at(a->data[0], meeting.point),
                   of_b = number_at(b->data[0], meeting.point);
      if (std::isnan(of_a) || std::isnan(of_b)) continue;
      size = std::max({size, std::fabs(of_a), std::fabs(of_b)});
      const std::string unknown = a->unknown.empty() ? "" : " of " + a->unknown;
      const std::string at = text_of(meeting.point, dimension_);
      if (std::fabs(of_a - of_b) > 1e-9 * size) {
        if (!by_structure)
          add(fmt::format(
              "values{} contradict each other: {:.6g} at {} and {:.6g} at {} meet at {}", unknown,
              of_a, a->name, of_b, b->name, at));
      } else if (by_structure) {
        add(fmt::format(
            "values{} at {} and {} have different formulas and meet at {}: by structure "
            "slopes jump there, and the order is lost; `enforce: weak` keeps it",
            unknown, a->name, b->name, at));
      }
    }
    next();
  }

  void look_at_natural(const std::vector<NaturalPiece>& natural, const std::set<int>& smooth) {
    const auto piece_of = [&](int primitive) -> const NaturalPiece* {
      const auto found = std::ranges::find_if(natural, [&](const NaturalPiece& piece) {
        return piece.condition.primitive == primitive;
      });
      return found == natural.end() ? nullptr : &*found;
    };
    for (const Meeting& meeting : meetings_) {
      const bool reentrant = meeting.angle > std::numbers::pi * (1 + 1e-6);
      if (!reentrant && dimension_ == 2) continue;
      const NaturalPiece* piece = piece_of(meeting.first);
      if (!piece) piece = piece_of(meeting.second);
      if (piece)
        add(rough(*piece, fmt::format("at its {} at {}", reentrant ? "reentrant corner" : "edge",
                                      text_of(meeting.point, dimension_))));
    }
    for (const NaturalPiece& piece : natural)
      if (smooth.contains(piece.condition.primitive))
        add(rough(piece, "where its piece goes on smoothly in another one"));
    next();
  }

  const std::vector<std::string>& notes() const { return notes_; }

 private:
  static std::string rough(const NaturalPiece& piece, const std::string& where) {
    return fmt::format(
        "the condition at {} is enforced by structure, which is rough {}: the order is "
        "lost; `enforce: weak` keeps it",
        piece.condition.name, where);
  }
  // The first of a kind, with how many there are more.
  void add(const std::string& note) {
    if (count_++ == 0) first_ = note;
  }
  void next() {
    if (count_ > 1) first_ += fmt::format(" (and at {} more places)", count_ - 1);
    if (count_ > 0) notes_.push_back(first_);
    count_ = 0;
  }

  int dimension_;
  Point center_;
  std::vector<Meeting> meetings_;
  std::vector<std::string> notes_;
  std::string first_;
  int count_ = 0;
};

bool have_several_data(const std::vector<PieceCondition>& conditions) {
  const PieceCondition* first = nullptr;
  for (const PieceCondition& piece : conditions) {
    if (piece.kind != Condition::Kind::value) continue;
    if (first &&
        !(first->component == piece.component && same_expression(first->data[0], piece.data[0])))
      return true;
    if (!first) first = &piece;
  }
  return false;
}

}  // namespace

std::vector<std::string> corner_notes(const std::vector<PieceCondition>& conditions,
                                      const std::vector<PieceCondition>& values_by_structure,
                                      const std::vector<NaturalPiece>& natural, bool own,
                                      const RegionEvaluator& region, const Box& bounds) {
  if (!have_several_data(conditions) && (own || natural.empty())) return {};
  CornerNotes notes(region, bounds);
  std::set<int> components;
  for (const PieceCondition& piece : conditions) components.insert(piece.component);
  for (const int component : components) {
    notes.look_at_values(conditions, component, false);
    if (!own) notes.look_at_values(values_by_structure, component, true);
  }
  if (!own && !natural.empty()) notes.look_at_natural(natural, smooth_joints(region, bounds));
  return notes.notes();
}

}  // namespace rfm
