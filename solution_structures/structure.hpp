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
/// structure is in use.
class Structure {
 public:
  /// One term a ∂^β Ψ_k.
  struct Term {
    int unknown = 0;
    MultiIndex derivative{};
    Field coefficient;
  };

  Structure() = default;
  Structure(const Field& inhomogeneous) : inhomogeneous_(inhomogeneous) {}  // NOLINT: g is affine
  Structure(double value) : inhomogeneous_(value) {}                        // NOLINT
  /// Ψ_k itself.
  static Structure undetermined(int unknown = 0);

  /// g, what is left of u when every Ψ vanishes.
  const Field& inhomogeneous() const { return inhomogeneous_; }
  /// The terms, sorted by unknown and derivative, each pair once, none with a zero coefficient.
  const std::vector<Term>& terms() const { return terms_; }
  /// Highest order of derivatives of any Ψ.
  int derivative_order() const;

  friend Structure operator+(const Structure& a, const Structure& b);
  friend Structure operator-(const Structure& a, const Structure& b);
  friend Structure operator*(const Field& factor, const Structure& structure);
  friend Structure partial(const Structure& structure, int axis);

 private:
  void add(const Term& term);
  Field inhomogeneous_;
  std::vector<Term> terms_;
};

Structure operator+(const Structure& a, const Structure& b);
Structure operator-(const Structure& a, const Structure& b);
Structure operator-(const Structure& a);
Structure operator*(const Field& factor, const Structure& structure);
/// ∂u/∂(axis) by the product rule.
Structure partial(const Structure& structure, int axis);
/// ∂^α u.
Structure partial(const Structure& structure, const MultiIndex& alpha);
/// ∇ω · ∇u.
Structure D(const Field& omega, const Structure& structure, int dimension);

}  // namespace rfm
