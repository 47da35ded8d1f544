#pragma once

#include <string>
#include <vector>

#include "core/field.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// A solution structure: an expression for an unknown u that is affine in undetermined functions Ψ,
///
///     u = g(x) + Σ_k Σ_β a_{k,β}(x) ∂^β Ψ_k ,
///
/// and satisfies boundary conditions whatever the Ψ are. Structures add, are multiplied by fields
/// and differentiate by the product rule, so that a builder is one line of algebra, written as in
/// the literature:
///
///     const Structure psi = Structure::undetermined();
///     const Structure dirichlet = g + omega * psi;
///     const Structure neumann = psi1 - omega * D(omega, psi1, dimension) + omega * omega * psi2;
///
/// `D(omega, ·)` is the derivative along the inward normal ∇ω. At a point a structure is a small
/// dense matrix from derivatives of basis functions to u; nothing else in the program knows which
/// structure is in use. Beside this sum a structure keeps the formula by which it was made, for
/// people to read (structure_text.hpp). The unknown of a system is a vector of structures, one per
/// component (vector_structure.hpp).
class Structure {
 public:
  /// One term a ∂^β Ψ_k.
  struct Term {
    int unknown = 0;
    MultiIndex derivative{};
    Field coefficient;
  };
  /// A part of the formula that is to be written as a call: `D(omega(hole), psi1)`.
  struct Call {
    Field value;
    std::string function;
    std::vector<Field> arguments;
  };

  Structure() = default;
  Structure(const Field& inhomogeneous)  // NOLINT: g is affine
      : inhomogeneous_(inhomogeneous), formula_(inhomogeneous) {}
  Structure(double value) : Structure(Field(value)) {}  // NOLINT
  /// Ψ_k itself. Throws `InvalidArgument` unless 0 ≤ k < 64.
  static Structure undetermined(int unknown = 0);

  /// g, what is left of u when every Ψ vanishes.
  const Field& inhomogeneous() const { return inhomogeneous_; }
  /// The terms, sorted by unknown and derivative, each pair once, none with a zero coefficient.
  const std::vector<Term>& terms() const { return terms_; }
  /// Highest order of derivatives of any Ψ.
  int derivative_order() const;
  /// One more than the largest number of a Ψ; 0 if there is none.
  int unknown_count() const;
  /// The same u as one expression in the Ψ (undetermined.hpp).
  const Field& formula() const { return formula_; }
  /// The calls in it, inner ones before those that use them.
  const std::vector<Call>& calls() const { return calls_; }
  /// The same structure with another formula: one that is equal, or reads better. `call`, if it has
  /// a name, is how `formula` itself is written.
  Structure written_as(const Field& formula, const Call& call = {}) const;

  // Found where one operand is a structure only: `omega * 2.0` is a product of fields.
  friend Structure operator+(const Structure& a, const Structure& b);
  friend Structure operator-(const Structure& a, const Structure& b);
  friend Structure operator-(const Structure& a);
  friend Structure operator*(const Field& factor, const Structure& structure);
  friend Structure operator/(const Structure& structure, const Field& divisor);
  friend Structure partial(const Structure& structure, int axis);
  /// `yes` where `condition` ≠ 0, else `no`; the other branch is not looked at.
  friend Structure select(const Field& condition, const Structure& yes, const Structure& no);

 private:
  void add(const Term& term);
  void add_terms(const Structure& other, double sign);
  void add_calls(const Structure& other);
  Field inhomogeneous_;
  std::vector<Term> terms_;
  Field formula_;
  std::vector<Call> calls_;
};

/// ∂u/∂(axis) by the product rule.
Structure partial(const Structure& structure, int axis);
/// ∂^α u.
Structure partial(const Structure& structure, const MultiIndex& alpha);
/// ∇u in `dimension` coordinates.
std::vector<Structure> gradient(const Structure& structure, int dimension);
/// ∇ω · ∇u.
Structure D(const Field& omega, const Structure& structure, int dimension);

/// f*(x) = f(x − ω∇ω) (core/composition.hpp) as a part of structures, written `normalizer(f, ω)`.
Structure normalized(const Field& f, const Field& omega, int dimension);

}  // namespace rfm
