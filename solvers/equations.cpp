#include "solvers/equations.hpp"

#include "solvers/assembly.hpp"
#include "solvers/solution.hpp"
#include "solvers/space_field.hpp"

namespace rfm {
namespace {

std::vector<Structure> homogeneous_parts(std::span<const Structure> structures) {
  std::vector<Structure> parts;
  for (const Structure& structure : structures) parts.push_back(homogeneous_part(structure));
  return parts;
}

SparseMatrix whole(const LinearSystem& system) {
  if (!system.symmetric) return system.matrix;
  return SparseMatrix(system.matrix.selfadjointView<Eigen::Lower>());
}

}  // namespace

Equations::Equations(std::vector<Structure> structures, std::vector<TensorProductSpace> spaces,
                     EquationTerms terms, const DomainRule& rule,
                     std::optional<SplineExtraction> extraction)
    : structures_(std::move(structures)),
      changes_(homogeneous_parts(structures_)),
      spaces_(std::move(spaces)),
      terms_(std::move(terms)),
      rule_(rule),
      extraction_(std::move(extraction)) {}

Equations::Equations(std::vector<Structure> structures, GlobalSpaces spaces, EquationTerms terms,
                     const DomainRule& rule)
    : structures_(std::move(structures)),
      changes_(homogeneous_parts(structures_)),
      global_spaces_(std::move(spaces)),
      terms_(std::move(terms)),
      rule_(rule) {}

int Equations::size() const {
  if (extraction_) return static_cast<int>(extraction_->matrix.cols());
  int size = 0;
  for (const auto& space : global_spaces_) size += space->size();
  for (const TensorProductSpace& space : spaces_) size += space.size();
  return size;
}

LinearSystem Equations::assembled(std::span<const Contribution> terms, double time) const {
  return assembled(structures_, terms, {time, {}});
}

LinearSystem Equations::assembled(std::span<const Structure> structures,
                                  std::span<const Contribution> terms,
                                  const FieldArguments& arguments) const {
  if (!global_spaces_.empty())
    return assemble_dense(structures, global_spaces_, terms, rule_, arguments);
  LinearSystem system = assemble(structures, spaces_, terms, rule_, arguments);
  return extraction_ ? extraction_->folded(system) : system;
}

const LinearSystem& Equations::steady() const {
  if (!steady_) steady_ = assembled(terms_.stiffness, 0);
  return *steady_;
}

const SparseMatrix& Equations::damping() const {
  if (!damping_) damping_ = assembled(terms_.damping, 0).matrix;
  return *damping_;
}

const SparseMatrix& Equations::mass() const {
  if (!mass_) mass_ = assembled(terms_.mass, 0).matrix;
  return *mass_;
}

Eigen::VectorXd Equations::load(double time) const {
  return time == 0 ? steady().right_hand_side : assembled(terms_.stiffness, time).right_hand_side;
}

Eigen::VectorXd Equations::residual(const Eigen::VectorXd& coefficients, double time) const {
  return -linearized(coefficients, {time, {}}).right_hand_side;
}

LinearSystem Equations::linearized(const Eigen::VectorXd& coefficients,
                                   const FieldArguments& arguments,
                                   const Eigen::VectorXd* held) const {
  std::vector<Contribution> tangents;
  if (!terms_.forms.empty()) {
    const std::vector<Field> solution = fields(coefficients);
    const std::vector<Field> held_solution = held ? fields(*held) : std::vector<Field>{};
    for (const Form& form : terms_.forms)
      tangents.push_back(form.linearized(solution, held_solution));
  }
  if (terms_.stiffness.empty()) return assembled(changes_, tangents, arguments);
  LinearSystem system = assembled(structures_, terms_.stiffness, arguments);
  system.right_hand_side -= whole(system) * coefficients;
  if (tangents.empty()) return system;
  const LinearSystem form = assembled(changes_, tangents, arguments);
  system.matrix = system.symmetric && form.symmetric ? SparseMatrix(system.matrix + form.matrix)
                                                     : SparseMatrix(whole(system) + whole(form));
  system.symmetric = system.symmetric && form.symmetric;
  system.right_hand_side += form.right_hand_side;
  return system;
}

Eigen::VectorXd Equations::loads_of_zero(const FieldArguments& arguments) const {
  std::vector<Contribution> terms = terms_.stiffness;
  const std::vector<Field> zero(structures_.size(), 0.0);
  for (const Form& form : terms_.forms) terms.push_back(form.linearized(zero));
  return assembled(changes_, terms, arguments).right_hand_side;
}

Equations Equations::with_rule(const DomainRule& rule) const {
  if (!global_spaces_.empty()) return Equations(structures_, global_spaces_, terms_, rule);
  return Equations(structures_, spaces_, terms_, rule, extraction_);
}

std::vector<Field> Equations::fields(const Eigen::VectorXd& coefficients) const {
  if (global_spaces_.empty())
    return solution_fields(
        structures_, spaces_,
        extraction_ ? Eigen::VectorXd(extraction_->matrix * coefficients) : coefficients);
  std::vector<Field> functions;
  const double* own = coefficients.data();
  for (const auto& space : global_spaces_) {
    functions.push_back(
        field(std::make_shared<SpaceField>(space, std::vector<double>(own, own + space->size()))));
    own += space->size();
  }
  std::vector<Field> solutions;
  for (const Structure& structure : structures_)
    solutions.push_back(solution_field(structure, functions));
  return solutions;
}

Structure homogeneous_part(const Structure& structure) {
  Structure result;
  for (const Structure::Term& term : structure.terms())
    result =
        result + term.coefficient * partial(Structure::undetermined(term.unknown), term.derivative);
  return result;
}

}  // namespace rfm
