#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "solvers/form_symbols.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// Where a form is integrated, as in `Contribution`.
struct FormPlace {
  Contribution::Place place = Contribution::Place::volume;
  std::vector<int> numbers{};
  std::optional<Field> where{};
};

/// A part of a problem as a formula, of any form: with d(u) the derivatives of the unknowns that
/// occur in it,
///
///     energy            ∫ W(x, d(u)), stationary;
///     weak              ∫ F(x, d(u); d(v)) = 0 for all test functions v, F linear in d(v);
///     least_squares     ∫ Σ w_i r_i(x, d(u))², least.
///
/// All come to the same: equations ∫ Σ_s F_s(x, d(u)) d_s(v) = 0 with the tangent
/// C_{s,t} = ∂F_s/∂d_t. F = ∂W/∂d and C is the Hessian of an energy; C is not symmetric in weak
/// forms; F_s = Σ w_i r_i ∂r_i/∂d_s and C_{s,t} = Σ w_i ∂r_i/∂d_s ∂r_i/∂d_t (Gauss and Newton) in
/// least squares. Derivatives by the slots are those of core/graph_derivative.hpp, so zeros and
/// constants are known beforehand.
///
///     const Field u = unknown_symbol(0, 2);
///     const Form area = Form::energy(sqrt(1 + dot(gradient(u, 2), gradient(u, 2))));
class Form {
 public:
  enum class Kind { energy, weak, least_squares };

  static Form energy(const Field& density, FormPlace place = {});
  /// Throws `InvalidArgument` if the density is not linear in the test functions.
  static Form weak(const Field& density, FormPlace place = {});
  /// One weight for each residual, or none, for weights of 1.
  static Form least_squares(const std::vector<Field>& residuals,
                            const std::vector<Field>& weights = {}, FormPlace place = {});

  Kind kind() const { return kind_; }
  const FormPlace& place() const { return place_; }
  /// Whether the tangent does not depend on the unknowns: seen from the formulas. Then one step of
  /// Newton's method from anywhere is the solution.
  bool is_linear() const;
  /// The derivatives of unknowns and test functions that occur.
  const std::vector<SymbolSlot>& slots() const { return slots_; }
  /// F_s, and C_{s,t}, with the unknowns as symbols: formulas of further forms.
  Field residual(const Slot& test, int dimension) const;
  Field tangent(const Slot& test, const Slot& trial, int dimension) const;
  /// The highest derivative of unknowns and test functions.
  int derivative_order() const;

  /// Tangent and residual of a linear form, as a contribution to the equations of the solution
  /// itself. Throws `InvalidArgument` if it is not linear.
  Contribution linear() const;
  /// Tangent and residual with fields in the place of the slots, by number, whatever they are
  /// derivatives of: with zeros, the equations of a form that is linear, if only by its values
  /// (solvers/linearity.hpp).
  Contribution at(const std::vector<Field>& slots) const;
  /// Tangent and residual where the solution is `components`: a contribution to the equations of
  /// its *change*, whose structure has no inhomogeneous part. What is held
  /// (solvers/form_symbols.hpp) has the values of `held_components` instead, if there are any.
  Contribution linearized(std::span<const Field> components,
                          std::span<const Field> held_components = {}) const;
  /// Whether anything in it is held, so that its tangent is not all of its slope.
  bool holds_anything() const;
  /// A residual of least squares, times the root of its weight, and its derivatives by the slots.
  struct ResidualRow {
    Field value;
    std::vector<std::pair<Slot, Field>> slopes;
  };
  /// The residuals where the solution is `components`. Throws `InvalidArgument` for other forms.
  std::vector<ResidualRow> residual_rows(std::span<const Field> components) const;
  /// W, or Σ w r² / 2, of a solution; 0 of a weak form.
  Field density(std::span<const Field> components) const;

 private:
  struct ResidualEntry {
    Slot test;
    Field value;
  };
  struct TangentEntry {
    Slot test, trial;
    Field value;
  };
  using Replacement = std::vector<Field>;  // by number of the slot

  Form(Kind kind, FormPlace place) : kind_(kind), place_(std::move(place)) {}
  void add_tangent(const Slot& test, const Slot& trial, const Field& value);
  Replacement slots_of(std::span<const Field> components,
                       std::span<const Field> held_components = {}) const;
  Replacement symbols(int dimension) const;

  Kind kind_;
  FormPlace place_;
  std::vector<SymbolSlot> slots_;
  Field density_ = 0.0;
  std::vector<ResidualEntry> residual_;
  std::vector<ResidualRow> rows_;
  std::vector<TangentEntry> tangent_;  // of energies and least squares, each pair of slots once
};

}  // namespace rfm
