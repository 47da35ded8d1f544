#pragma once

#include <optional>
#include <vector>

#include "core/field.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// A coefficient of an integrand: a polynomial Σ_α n^α f_α(x) in the components of the outward unit
/// normal n of the boundary, which is known at points of quadrature but is not a field. In the
/// volume only its constant term makes sense.
///
///     const Coefficient flux = conductivity * Coefficient::normal(0);       // k n_x
class Coefficient {
 public:
  struct Term {
    MultiIndex normal{};  ///< α: powers of n_x, n_y, n_z
    Field field;
  };

  Coefficient() = default;
  Coefficient(const Field& field);                          // NOLINT: fields are coefficients
  Coefficient(double value) : Coefficient(Field(value)) {}  // NOLINT
  /// n_axis, a component of the outward unit normal.
  static Coefficient normal(int axis);

  /// The terms, each power of the normal once, none with a zero field.
  const std::vector<Term>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  bool depends_on_normal() const;

  friend Coefficient operator+(const Coefficient& a, const Coefficient& b);
  friend Coefficient operator*(const Coefficient& a, const Coefficient& b);

 private:
  void add(const Term& term);
  std::vector<Term> terms_;
};

Coefficient operator+(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a, const Coefficient& b);
Coefficient operator-(const Coefficient& a);
Coefficient operator*(const Coefficient& a, const Coefficient& b);

/// ∂^derivative u_component: what an integrand knows of the solution.
struct Slot {
  int component = 0;
  MultiIndex derivative{};
  bool operator==(const Slot&) const = default;
};

/// A quadratic density of energy as data: with d the values of the slots,
///
///     W = ½ dᵀ C d − bᵀ d,       C symmetric.
///
/// Entries that are never added are zero and cost nothing.
///
///     QuadraticEnergy heat;                            // ½ k |∇u|² − f u in the plane
///     for (int axis : {0, 1}) heat.add_stiffness({0, unit_index(axis)}, {0, unit_index(axis)}, k);
///     heat.add_load({0, {}}, f);
class QuadraticEnergy {
 public:
  struct Entry {
    int row = 0, column = 0;  ///< numbers of slots, row ≤ column
    Coefficient coefficient;
  };
  struct Load {
    int slot = 0;
    Coefficient coefficient;
  };

  /// C(a, b) and, for a ≠ b, C(b, a) grow by `coefficient`: ½ dᵀ C d grows by ½ c d_a² if a = b and
  /// by c d_a d_b if not.
  void add_stiffness(const Slot& a, const Slot& b, const Coefficient& coefficient);
  /// b(a) grows by `coefficient`.
  void add_load(const Slot& a, const Coefficient& coefficient);

  const std::vector<Slot>& slots() const { return slots_; }
  const std::vector<Entry>& stiffness() const { return stiffness_; }
  const std::vector<Load>& load() const { return load_; }
  bool depends_on_normal() const;

 private:
  int number(const Slot& slot);
  std::vector<Slot> slots_;
  std::vector<Entry> stiffness_;
  std::vector<Load> load_;
};

/// A term c ∂^trial u ∂^test v of a weak form, with the test function v, that does not follow from
/// an energy: advection, or the tangent of a weak form at a state.
struct Coupling {
  Slot test, trial;
  Coefficient coefficient;
};

/// An energy, and perhaps terms of a weak form beside it, and where they are integrated: the
/// equations are
///
///     Σ ∫ d(v)ᵀ (C d(u) − b) + Σ ∫ c ∂^trial u ∂^test v = 0        for all v,
///
/// the first sum being the derivative of the energy. With couplings the matrix is not symmetric.
struct Contribution {
  enum class Place { volume, boundary, interface };
  QuadraticEnergy energy;
  Place place = Place::volume;
  /// The primitives of the region whose pieces of the boundary count, or the interfaces; none means
  /// all.
  std::vector<int> numbers{};
  /// Only where this field is ≥ 0. Quadrature does not know of the step, so that a field that
  /// changes sign within a cell costs order; split the primitive to keep it.
  std::optional<Field> where{};
  std::vector<Coupling> couplings{};
};

}  // namespace rfm
