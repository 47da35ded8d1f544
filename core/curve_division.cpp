#include "core/curve_division.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr double rounding = 1e-9;  // of directions: below it they are parallel
constexpr int most_rounds = 12;

int sign_of(double sine) { return sine > rounding ? 1 : sine < -rounding ? -1 : 0; }

bool is_inflection(const CurvePiece& before, const CurvePiece& after) {
  return before.turn * after.turn < 0 &&
         sign_of(cross(before.end_direction(), after.start_direction())) == 0;
}

// Whether the chords at a corner turn as the curves do, and each curve lies on the right side of
// the chord of the other.
bool is_consistent(const CurvePiece& before, const CurvePiece& after) {
  if (is_inflection(before, after)) return true;  // the tangent stands between them
  const int turn = sign_of(cross(before.chord(), after.chord()));
  if (turn == 0) return false;
  const int of_before = sign_of(cross(before.end_direction(), after.chord()));
  const int of_after = sign_of(cross(before.chord(), after.start_direction()));
  // Along the chord itself curvature decides.
  return (of_before == 0 ? before.turn : of_before) == turn &&
         (of_after == 0 ? after.turn : of_after) == turn;
}

class Divider {
 public:
  Divider(std::vector<std::vector<CurvePiece>>& contours, const std::vector<std::string>& names)
      : contours_(contours), names_(names) {}

  void run() {
    for (int round = 0; mark(); ++round) {
      if (round == most_rounds) refuse();
      for (std::size_t c = 0; c < contours_.size(); ++c) {
        std::vector<CurvePiece> finer;
        for (std::size_t i = 0; i < contours_[c].size(); ++i) {
          const CurvePiece& piece = contours_[c][i];
          if (!marked_[c][i]) {
            finer.push_back(piece);
            continue;
          }
          for (const CurvePiece& half : piece.halves()) finer.push_back(half);
        }
        contours_[c] = std::move(finer);
      }
    }
  }

 private:
  struct Position {
    std::size_t contour, piece;
  };

  // Marks pieces that have to be divided; false if there are none.
  bool mark() {
    marked_.clear();
    std::vector<Position> all;
    std::vector<std::array<Point, 4>> hulls;
    for (std::size_t c = 0; c < contours_.size(); ++c) {
      marked_.emplace_back(contours_[c].size(), contours_[c].size() < 3);
      for (std::size_t i = 0; i < contours_[c].size(); ++i) {
        all.push_back({c, i});
        hulls.push_back(contours_[c][i].hull());
      }
    }
    bool any = std::ranges::any_of(contours_, [](const auto& list) { return list.size() < 3; });
    for (std::size_t i = 0; i < all.size(); ++i)
      for (std::size_t j = i + 1; j < all.size(); ++j) {
        const CurvePiece &p = at(all[i]), &q = at(all[j]);
        const bool same = all[i].contour == all[j].contour;
        const std::size_t count = contours_[all[i].contour].size();
        const bool follows = same && all[j].piece == all[i].piece + 1;
        const bool precedes = same && all[i].piece == 0 && all[j].piece == count - 1;
        bool is_apart = true;
        if (follows) is_apart = !cones_meet(p, q);
        if (precedes) is_apart = is_apart && !cones_meet(q, p);
        if (!follows && !precedes) is_apart = !hulls_meet(hulls[i], hulls[j]);
        if (is_apart && follows) is_apart = joins(p, q);
        if (is_apart && precedes) is_apart = joins(q, p);
        if (is_apart) continue;
        any = true;
        worst_ = {std::min(p.edge, q.edge), std::max(p.edge, q.edge)};
        if (p.is_straight() && q.is_straight()) refuse();
        mark_curved(all[i]);
        mark_curved(all[j]);
      }
    return any;
  }

  // Straight edges on one line are one edge for the caller.
  static bool joins(const CurvePiece& p, const CurvePiece& q) {
    return is_consistent(p, q) || (p.is_straight() && q.is_straight());
  }
  const CurvePiece& at(const Position& place) const {
    return contours_[place.contour][place.piece];
  }
  void mark_curved(const Position& place) {
    if (!at(place).is_straight()) marked_[place.contour][place.piece] = true;
  }
  [[noreturn]] void refuse() const {
    if (worst_[0] == worst_[1])
      throw InvalidArgument(names_[worst_[0]] + " cannot be told from its neighbours");
    throw InvalidArgument(names_[worst_[0]] + " and " + names_[worst_[1]] +
                          " cross, touch or nearly touch each other");
  }

  std::vector<std::vector<CurvePiece>>& contours_;
  const std::vector<std::string>& names_;
  std::vector<std::vector<bool>> marked_;
  std::array<int, 2> worst_{};
};

double length(const CurvePiece& piece) {
  return std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
}

// The tangent at the beginning of `after`: short enough not to change how chords lie.
ContourLink tangent_at(const CurvePiece& before, const CurvePiece& after) {
  const Point along = after.start_direction(), at = after.from;
  const double step = 1e-6 * std::min(length(before), length(after));
  const auto moved = [&](double s) { return Point{at[0] + s * along[0], at[1] + s * along[1]}; };
  return {CurvePiece::straight(moved(-step), moved(step), after.edge), moved(-step), true};
}

}  // namespace

std::vector<std::vector<ContourLink>> divided(std::vector<std::vector<CurvePiece>> contours,
                                              const std::vector<std::string>& names) {
  Divider(contours, names).run();
  std::vector<std::vector<ContourLink>> result;
  for (const auto& pieces : contours) {
    std::vector<ContourLink>& links = result.emplace_back();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const CurvePiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
      Point start = pieces[i].from;
      if (is_inflection(before, pieces[i])) {
        links.push_back(tangent_at(before, pieces[i]));
        start = links.back().piece.to;
      }
      links.push_back({pieces[i], start, false});
    }
  }
  return result;
}

}  // namespace rfm
