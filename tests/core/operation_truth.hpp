#pragma once

#include <array>
#include <vector>

#include "tests/core/operation_rows.hpp"

namespace rfm {

/// What an operation truly is at a point: the Taylor coefficients f_α of its definition (the
/// `reference` of the table, in power series of 700 digits) in its own arguments, and what they are
/// conditioned like.
struct OperationTruth {
  int arity = 0, order = 0;
  bool is_defined = false;  ///< the value is a finite number
  bool is_smooth = false;   ///< else derivatives are a convention: finite where the value is
  bool is_cut = false;      ///< the sign of a zero decides about the value
  std::vector<long double> coefficients;
  /// w_α = |f_α| + Σᵢ |aᵢ| (αᵢ + 1) |f_{α+eᵢ}|: how much f_α changes, in units of a relative change
  /// of itself and of the values aᵢ of the arguments (not below that of a normal number).
  std::vector<long double> weights;
  std::vector<bool> is_known;      ///< whether the digits sufficed
  std::vector<long double> least;  ///< by degree: see `Expected`
  std::vector<bool> overflows;     ///< by degree: see `Expected`
};

OperationTruth truth_of(const Row& row, const std::array<double, 3>& arguments, int order);

/// The arguments of an operation as functions of N variables about a point: constant coefficients
/// are the values, these are the others, exact in double precision, up to an order.
struct ArgumentShape {
  enum class Kind { own, mixed, proportional };
  int variables, order;
  Kind kind;
  std::array<std::vector<double>, 3> coefficients;

  /// a = x, b = y, c = z: the Taylor coefficients are those of the operation itself.
  static ArgumentShape own(int variables, int order);
  /// Polynomials in all variables, of second degree.
  static ArgumentShape mixed(int variables, int order);
  /// The values of the arguments times such polynomials, whose value is 1: as functions whose scale
  /// is arbitrary, or exponential ones. The other coefficients are given as multiples of the value,
  /// which are whole numbers.
  static ArgumentShape proportional(int variables, int order);
};

/// A Taylor coefficient of f(a(x), b(x), c(x)) and its condition, the same sum with the weights and
/// with absolute values of the coefficients of the arguments:
///
///     F_β = Σ_α f_α [(a − a₀)^α₁ (b − b₀)^α₂ …]_β,   C_β = Σ_α (w_α + d |f_α|) [|a − a₀|^α₁ …]_β .
///
/// A relative change of u of what is given, the values and the coefficients of the arguments, and
/// of each intermediate f_α changes F_β by up to u C_β: this is what "8 ulp of the condition"
/// means, |found − F_β| ≤ 8 u C_β, u = 2⁻⁵³. The d = |α| coefficients in a product count where
/// arguments are functions; those of arguments that are the variables themselves are ones, d = 0.
/// Not covered by it are numbers below the normal ones and f_α that overflow. Absolute errors of a
/// few times 2⁻¹⁰²², the smallest normal number, are admitted; of operations with several
/// arguments, which are composed of others, times |a|^±|β| for each argument. Where an f_α with |α|
/// ≤ |β| or that power overflows "not finite" is a right answer for F_β, but a wrong number never
/// is.
///
/// Of arguments a₀ (1 + e) the sums are those of f_α a₀^α and of w_α |a₀|^α with the monomials of
/// e, which are of one size whatever that of a₀ is. The smallest normal number is what each of
/// these products may be wrong by, of functions of degree one, f(c a, c b) = c f(a, b), in units of
/// the largest argument, to which the others are scaled; |a₀| counts as no smaller than it. "Not
/// finite" is right only where C_β overflows.
struct Expected {
  long double value = 0, condition = 0;
  long double least = 0;  ///< absolute error that is admitted besides
  bool overflows = false, is_known = true;
};
class Composition {
 public:
  Composition(const ArgumentShape& shape, int arity);
  std::vector<Expected> operator()(const OperationTruth& truth,
                                   const std::array<double, 3>& arguments) const;

 private:
  long double weight(const OperationTruth& truth, std::size_t alpha) const;
  std::vector<Expected> of_proportional(const OperationTruth& truth,
                                        const std::array<double, 3>& arguments) const;

  ArgumentShape::Kind kind_;
  int variables_, order_, arity_, size_;
  // For each α the coefficients of its monomial in the increments of the arguments, those of their
  // absolute values, and how many of them that are given each product has.
  std::vector<std::vector<double>> monomials_, majorants_;
  std::vector<int> degrees_;
};

}  // namespace rfm
