#include "solvers/compiled_integrand.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.hpp"

namespace rfm {
namespace {

std::string name_of(const MultiIndex& derivative) {
  static constexpr const char* letters[] = {"x", "y", "z", "t"};
  std::string name;
  for (int axis = 0; axis < 4; ++axis)
    for (int i = 0; i < derivative[axis]; ++i) name += letters[axis];
  return name.empty() ? name : "_" + name;
}

}  // namespace

int CompiledIntegrand::scalar(const Field& field, const std::string& name,
                              std::vector<Field>& roots) {
  if (field.is_constant()) {
    scalars_.push_back({-1, field.constant(), name});
  } else {
    int root = 0;
    while (root < static_cast<int>(roots.size()) && !roots[root].same_as(field)) ++root;
    if (root == static_cast<int>(roots.size()))
      roots.push_back(field);
    else  // the same field twice needs one array only
      for (std::size_t known = 0; known < scalars_.size(); ++known)
        if (scalars_[known].root == root) return static_cast<int>(known);
    scalars_.push_back({root, 0, name});
  }
  return static_cast<int>(scalars_.size()) - 1;
}

int CompiledIntegrand::basis_derivative(int unknown, const MultiIndex& derivative) {
  for (std::size_t m = 0; m < basis_derivatives_.size(); ++m)
    if (basis_derivatives_[m].unknown == unknown && basis_derivatives_[m].derivative == derivative)
      return static_cast<int>(m);
  basis_derivatives_.push_back({unknown, derivative});
  return static_cast<int>(basis_derivatives_.size()) - 1;
}

// The number of a slot, which is made with its row of M and its inhomogeneous part.
int CompiledIntegrand::slot(const Slot& slot, std::span<const Structure> structures,
                            std::vector<Field>& roots) {
  const auto known = std::find(slots_.begin(), slots_.end(), slot);
  const int number = static_cast<int>(known - slots_.begin());
  if (known != slots_.end()) return number;
  if (slot.component < 0 || slot.component >= static_cast<int>(structures.size()))
    throw InvalidArgument(
        fmt::format("an integrand asks for component {} of {}", slot.component, structures.size()));
  slots_.push_back(slot);
  const Structure row = partial(structures[slot.component], slot.derivative);
  const std::string name = fmt::format("u{}{}", slot.component, name_of(slot.derivative));
  inhomogeneous_.push_back(
      row.inhomogeneous().is_constant(0)
          ? -1
          : scalar(row.inhomogeneous(), "the inhomogeneous part of " + name, roots));
  for (const Structure::Term& term : row.terms())
    map_.push_back(
        {number, basis_derivative(term.unknown, term.derivative),
         scalar(term.coefficient, "the factor of the undetermined function in " + name, roots)});
  return number;
}

CompiledIntegrand::CompiledIntegrand(const Contribution& contribution,
                                     std::span<const Structure> structures, int dimension)
    : contribution_(contribution) {
  const QuadraticEnergy& energy = contribution_.energy;
  const bool has_normal =
      energy.depends_on_normal() ||
      std::any_of(contribution_.couplings.begin(), contribution_.couplings.end(),
                  [](const Coupling& term) { return term.coefficient.depends_on_normal(); });
  if (contribution_.place == Contribution::Place::volume && has_normal)
    throw InvalidArgument("an integrand over the volume cannot depend on the normal");
  std::vector<Field> roots;
  for (const Slot& own : energy.slots()) slot(own, structures, roots);
  const auto terms_of = [&](const Coefficient& coefficient, const char* name) {
    std::vector<NormalTerm> terms;
    for (const Coefficient::Term& term : coefficient.terms())
      terms.push_back({term.normal, scalar(term.field, name, roots)});
    return terms;
  };
  for (const QuadraticEnergy::Entry& entry : energy.stiffness())
    stiffness_.push_back(
        {entry.row, entry.column, terms_of(entry.coefficient, "a coefficient of the equation")});
  for (const Coupling& coupling : contribution_.couplings) {
    if (coupling.coefficient.is_zero()) continue;
    const int test = slot(coupling.test, structures, roots);
    const int trial = slot(coupling.trial, structures, roots);
    stiffness_.push_back(
        {test, trial, terms_of(coupling.coefficient, "a coefficient of the equation"), false});
  }
  for (const QuadraticEnergy::Load& load : energy.load())
    load_.push_back({load.slot, terms_of(load.coefficient, "a source or a datum of a condition")});
  if (contribution_.where) where_ = scalar(*contribution_.where, "the restriction", roots);
  tape_ = std::make_unique<const Tape>(std::move(roots), std::vector<int>{0}, dimension);
}

}  // namespace rfm
