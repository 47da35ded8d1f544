#include "core/curve_division.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

constexpr int most_rounds = 12;

double dot(const Point& a, const Point& b) { return a[0] * b[0] + a[1] * b[1]; }

double length(const CurvePiece& piece) {
  return std::hypot(piece.to[0] - piece.from[0], piece.to[1] - piece.from[1]);
}

// How the contour turns where one piece follows another.
class Corner {
 public:
  Corner(const CurvePiece& before, const CurvePiece& after) : before_(before), after_(after) {
    sine_ = cross(before.end_direction(), after.start_direction());
    const bool ahead = dot(before.end_direction(), after.start_direction()) > 0;
    is_gentle_ = ahead && std::fabs(sine_) < 0.05;
    turn_ = sine_ > 0 ? 1 : -1;
    if (ahead && std::fabs(sine_) <= negligible()) turn_ = 0;
  }

  // Whether the chords turn as the curves do, and each curve lies on the right side of the chord of
  // the other.
  bool chords_suffice() const {
    if (before_.is_straight() && after_.is_straight()) return true;
    const double turns = cross(before_.chord(), after_.chord());
    const int chords = turns > 0 ? 1 : turns < 0 ? -1 : 0;
    const int one = before_.turn, other = after_.turn;
    if (turn_ == 0 && one * other >= 0) return chords == (one != 0 ? one : other);
    const auto side = [](double sine, int of_curve) {  // along the chord curvature decides
      return std::fabs(sine) > 1e-9 ? (sine > 0 ? 1 : -1) : of_curve;
    };
    const int of_before = side(cross(before_.end_direction(), after_.chord()), one);
    const int of_after = side(cross(before_.chord(), after_.start_direction()), other);
    return std::fabs(turns) > 1e-9 && of_before == chords && of_after == chords;
  }

  // Whether chords and tangents can tell.
  bool is_told() const { return chords_suffice() || is_gentle_; }

  // Tangents between the pieces, and `next`, the second of them.
  void add_links(std::vector<ContourLink>& links, const CurvePiece& next) const {
    const int one = before_.turn, other = after_.turn;
    if (chords_suffice()) {
      const double turns = cross(before_.chord(), after_.chord());
      const bool straight = one == 0 && other == 0;
      links.push_back({next, false, straight ? 0 : turns > 0 ? 1 : -1});
      return;
    }
    int turn = turn_;
    if (one != 0 && turn_ != 0 && one != turn_)
      links.push_back({tangent(before_.end_direction()), true, one});
    else if (turn_ == 0)
      turn = one;
    if (other == turn_) {
      links.push_back({next, false, turn});
      return;
    }
    if (other != 0) {
      links.push_back({tangent(after_.start_direction()), true, turn});
      turn = other;
    }
    links.push_back({next, false, turn});
  }

 private:
  // The sine below which a curve that starts on the wrong side of the tangent of the other is back
  // before it has left by anything: by its square.
  double negligible() const {
    double opening = 1;  // between chords and tangents
    for (const CurvePiece* piece : {&before_, &after_})
      if (!piece->is_straight())
        opening = std::min(opening, std::fabs(cross(piece->chord(), piece->start_direction())));
    const double shortest = std::min(length(before_), length(after_));
    const double rounding =
        1e-13 + 4e-15 * (std::fabs(after_.from[0]) + std::fabs(after_.from[1])) / shortest;
    return std::max(rounding, std::min(1e-8, 1e-6 * opening));
  }

  CurvePiece tangent(const Point& direction) const {
    const double step = std::min(length(before_), length(after_));
    const Point& at = after_.from;
    return CurvePiece::straight(at, {at[0] + step * direction[0], at[1] + step * direction[1]},
                                after_.edge);
  }

  CurvePiece before_, after_;
  double sine_ = 0;
  bool is_gentle_ = false;
  int turn_ = 0;
};

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
        if (is_apart && follows) is_apart = Corner(p, q).is_told();
        if (is_apart && precedes) is_apart = Corner(q, p).is_told();
        if (is_apart) continue;
        any = true;
        worst_ = {std::min(p.edge, q.edge), std::max(p.edge, q.edge)};
        if (p.is_straight() && q.is_straight()) refuse();
        mark_curved(all[i]);
        mark_curved(all[j]);
      }
    return any;
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

}  // namespace

std::vector<std::vector<ContourLink>> divided(std::vector<std::vector<CurvePiece>> contours,
                                              const std::vector<std::string>& names) {
  Divider(contours, names).run();
  std::vector<std::vector<ContourLink>> result;
  for (const auto& pieces : contours) {
    std::vector<ContourLink>& links = result.emplace_back();
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      const CurvePiece& before = pieces[(i + pieces.size() - 1) % pieces.size()];
      Corner(before, pieces[i]).add_links(links, pieces[i]);
    }
  }
  return result;
}

}  // namespace rfm
