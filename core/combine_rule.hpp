#pragma once

#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/r_systems.hpp"

namespace rfm {

/// Products where they are right, R₀-functions elsewhere: see `weight`.
struct AutomaticRule {};
/// A product of all conjuncts, whatever the angles; disjunctions are R₀.
struct ProductRule {};
/// As `AutomaticRule`, each factor levelled off at a distance of `width` (`plateau`): power − 1
/// times differentiable. Away from the boundary the weight is 1 and Ψ is u − g itself, but the
/// edge of the plateau is inside cells: the order of convergence does not exceed about power + ½.
struct PlateauRule {
  double width = 1;
  int power = 3;
};

/// How a Boolean expression becomes a weight; an `RSystem` is used throughout.
using CombineRule = std::variant<AutomaticRule, ProductRule, PlateauRule, RSystem>;

/// ω / (1 + |βω|^α): zeros and slopes of ω, but bounded for α ≥ 1. β is one over a length.
struct Saturation {
  double alpha = 2;  ///< at least 1; even keeps ω smooth
  double beta = 1;
};

/// Two primitives (or shapes) whose functions vanish together at a corner or edge, where the weight
/// is joined by R-equivalence with their distance from it over `scale`: near it the weight is no
/// larger than that, for any direction. Large scales flatten the weight there, small ones leave it
/// as it is.
struct CornerScale {
  std::string first, second;
  double scale = 1;
};
/// The function of a primitive (or shape) divided by `scale`: slope 1/scale on its piece.
struct PieceScale {
  std::string name;
  double scale = 1;
};

/// What `weight` makes of a region. Saturation, cap and scales shape the normalised function of
/// every primitive before they are combined (Shapiro 2007, §7.3); a product then multiplies those
/// functions instead of levels.
struct WeightOptions {
  CombineRule rule = AutomaticRule{};
  std::optional<Saturation> saturation;
  /// R₀-conjunction with this field, which must be positive in the region.
  std::optional<Field> cap;
  std::vector<PieceScale> piece_scales;
  std::vector<CornerScale> corner_scales;

  WeightOptions() = default;
  WeightOptions(CombineRule rule) : rule(std::move(rule)) {}  // NOLINT: a rule alone is usual
  /// Whether primitives enter as they are.
  bool plain() const { return !saturation && !cap && piece_scales.empty(); }
};

}  // namespace rfm
