#pragma once

#include <optional>
#include <span>
#include <vector>

#include "basis/tensor_product_space.hpp"
#include "core/field.hpp"
#include "quadrature/domain_rule.hpp"
#include "solution_structures/structure.hpp"
#include "solvers/dense_assembly.hpp"
#include "solvers/extraction.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/form.hpp"
#include "solvers/integrand.hpp"
#include "solvers/linear_system.hpp"

namespace rfm {

/// What a problem integrates, each term an energy ½ dᵀ C d − bᵀ d over a part of the domain or its
/// boundary: ½ uᵀ K u − fᵀ u, ½ u'ᵀ C u' and ½ u'ᵀ M u'. What is not linear is a form.
struct EquationTerms {
  std::vector<Contribution> stiffness;  ///< with the loads
  std::vector<Contribution> damping{};
  std::vector<Contribution> mass{};
  std::vector<Form> forms{};  ///< N(u), with its loads
};

/// The equations of a problem on one grid, before it is said what is asked of them:
///
///     M c'' + C c' + K c + N(c, t) = f(t)
///
/// for the coefficients c of the undetermined functions. Studies are drivers over it: the steady
/// one solves K c = f, Newton's method takes residual and tangent at c and t, eigenvalues are those
/// of K and M, time integration takes M or C besides.
/// Matrices are assembled when first asked for, once. The rule must outlive the equations.
///
///     Equations heat({omega * psi}, {space}, {.stiffness = {conduction}, .damping = {capacity}},
///     rule); const LinearSolution steady = solve(heat.steady());
class Equations {
 public:
  /// `structures[c]` is component c of the solution, `spaces[k]` holds undetermined function k.
  /// With an extraction c are the coefficients of its combinations, everywhere.
  Equations(std::vector<Structure> structures, std::vector<TensorProductSpace> spaces,
            EquationTerms terms, const DomainRule& rule,
            std::optional<SplineExtraction> extraction = {});
  /// The same with functions that live on the whole domain.
  Equations(std::vector<Structure> structures, GlobalSpaces spaces, EquationTerms terms,
            const DomainRule& rule);

  int size() const;
  const std::vector<Structure>& structures() const { return structures_; }
  /// The spaces of splines; none where functions are global.
  const std::vector<TensorProductSpace>& spaces() const { return spaces_; }
  const GlobalSpaces& global_spaces() const { return global_spaces_; }
  const std::optional<SplineExtraction>& extraction() const { return extraction_; }
  const EquationTerms& terms() const { return terms_; }
  const DomainRule& rule() const { return rule_; }

  /// K and f at time 0.
  const LinearSystem& steady() const;
  /// Lower triangles; zero where there are no such terms.
  const SparseMatrix& stiffness() const { return steady().matrix; }
  const SparseMatrix& damping() const;
  const SparseMatrix& mass() const;
  /// f(t). Inhomogeneous parts of structures that depend on time would also load through M and C:
  /// they are not covered.
  Eigen::VectorXd load(double time) const;
  /// K c + N(c, t) − f(t).
  Eigen::VectorXd residual(const Eigen::VectorXd& coefficients, double time) const;
  /// Its tangent, K + ∂N/∂c, and minus the residual, as Newton's method asks for them. What the
  /// tangent does not count (`held`, solvers/form_symbols.hpp) stays as at the state `held`.
  LinearSystem linearized(const Eigen::VectorXd& coefficients, const FieldArguments& arguments = {},
                          const Eigen::VectorXd* held = nullptr) const;
  /// Minus the residual where the whole solution is zero, data of structures included: of the size
  /// of the loads. Throws `ComputationError` where forms are not defined there.
  Eigen::VectorXd loads_of_zero(const FieldArguments& arguments = {}) const;
  /// The same equations by another rule.
  Equations with_rule(const DomainRule& rule) const;
  /// The sum of terms at a time, as a system in the coefficients.
  LinearSystem assembled(std::span<const Contribution> terms, double time = 0) const;
  /// The solution with these coefficients, one field per component.
  std::vector<Field> fields(const Eigen::VectorXd& coefficients) const;

 private:
  LinearSystem assembled(std::span<const Structure> structures, std::span<const Contribution> terms,
                         const FieldArguments& arguments) const;

  std::vector<Structure> structures_, changes_;  // changes have no inhomogeneous part
  std::vector<TensorProductSpace> spaces_;
  GlobalSpaces global_spaces_;
  EquationTerms terms_;
  const DomainRule& rule_;
  std::optional<SplineExtraction> extraction_;
  mutable std::optional<LinearSystem> steady_;
  mutable std::optional<SparseMatrix> damping_, mass_;
};

/// The structure without its inhomogeneous part: differences of two functions of that form.
Structure homogeneous_part(const Structure& structure);

}  // namespace rfm
