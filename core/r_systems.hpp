#pragma once

#include <functional>
#include <limits>
#include <ostream>
#include <string>
#include <variant>

#include "core/field.hpp"

namespace rfm {

// Systems of R-functions: what conjunction and disjunction are made of (r_functions.hpp). All are
// commutative and obey De Morgan's laws; only R₁ is associative. "Normalised to order k" says that
// on the face x = 0 of a conjunction x ∧ y = x + O(x^{k+1}), so that ∂/∂n = 1 and the higher normal
// derivatives up to order k vanish if they do for x.
//
// Sources: V. L. Rvachev (1982); V. Shapiro, Semi-analytic geometry with R-functions, Acta Numerica
// 16 (2007), §3.3; V. Shapiro, Theory of R-functions and applications: a primer (1991), §1.3.

/// x ∧ y = (x + y − √(x² + y² − 2αxy)) / (1 + α), eq. (3.3), −1 < α ≤ 1; α = 0 is R₀, eq. (3.4),
/// α = 1 is R₁. Analytic but at x = y = 0; normalised to order 1.
struct RAlpha {
  double alpha = 0;
};
/// x ∧ y = min(x, y): exact on both faces, but with a kink wherever x = y.
struct R1 {};
/// x ∧ y = x + y − (xᵖ + yᵖ)^(1/p), eq. (3.6), p even from 2 to 64; p = 2 is R₀. Analytic but at
/// x = y = 0; normalised to order p − 1.
struct Rp {
  int p = 4;
};
/// Rα with a field: α must lie in (−1, 1] and depend on x and y only as α(x, y) = α(y, x) =
/// α(−x, y) = α(x, −y), or else commutativity and De Morgan's laws fail. This cannot be checked.
struct RAlphaField {
  Field alpha;
};
/// x ∧ y = (x ∧α y)(x² + y²)^{m/2}, eq. (3.5) with α = 0 (R₀ᵐ), m from 1 to 16: m times
/// differentiable everywhere, for the price of being normalised nowhere. Of degree m + 1, so that d
/// of them within one another are of degree (m + 1)ᵈ: signs are kept as long as arguments to that
/// power are numbers (m = 16 and d = 2: from 0.1 to 10).
struct RAlphaM {
  double alpha = 0;
  int m = 1;
};
/// x ∧ y = sign(x + y) |½(x + y)|ᵐ − |½(x − y)|ᵐ, m from 1 to 16: without roots; m − 1 times
/// differentiable, not normalised for m > 1; m = 1 is R₁. Of degree m: see `RAlphaM`.
struct RCm {
  int m = 2;
};
/// A system of one's own. Everything that takes an `RSystem` takes it:
///
///     const RSystem quartic = UserSystem{"quartic", [](const Field& x, const Field& y) {
///       return x + y - sqrt(sqrt(pow(x, 4) + x * x * y * y + pow(y, 4))); }};
///
/// `conjunction` must be continuous and positive exactly where both arguments are (else it is no
/// R-conjunction), and should be commutative: weights join fields in no promised order.
struct UserSystem {
  using Operation = std::function<Field(const Field&, const Field&)>;
  /// In formulas: conjunctions are written name_and(x, y).
  std::string name;
  Operation conjunction;
  /// Where it is not given, by De Morgan's law.
  Operation disjunction = {};
  int normalization_order = 0;  ///< as above; 0 promises nothing
  std::string smoothness = "as its author made it";
};

using RSystem = std::variant<RAlpha, R1, Rp, RAlphaField, RAlphaM, RCm, UserSystem>;

/// The parameter in a few words, as "R-alpha, alpha = 0.5".
std::ostream& operator<<(std::ostream& stream, const RSystem& system);

inline constexpr int every_order = std::numeric_limits<int>::max();
/// To which order conjunctions and disjunctions keep normalisation on a face: 1 for Rα, p − 1 for
/// Rp, `every_order` for R₁, 0 where they do not keep it.
int normalization_order(const RSystem& system);
/// How smooth conjunctions of smooth functions are, in words.
std::string smoothness_text(const RSystem& system);
/// Conjunction (or disjunction) of two formulas as a formula: `r0_and(a, b)`, `min(a, b)`. Rα, R₁
/// and Rp are operations of formulas (docs/fields.md), the others functions that
/// `define_r_functions` (r_system_functions.hpp) defines, except those of a `UserSystem`, which are
/// names only.
std::string operation_text(const RSystem& system, bool conjunction, const std::string& a,
                           const std::string& b);

}  // namespace rfm
