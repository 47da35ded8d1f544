#include "solvers/equations.hpp"

#include "solvers/assembly.hpp"
#include "solvers/solution.hpp"
#include "solvers/space_field.hpp"

namespace rfm {

Equations::Equations(std::vector<Structure> structures, std::vector<TensorProductSpace> spaces,
                     EquationTerms terms, const DomainRule& rule,
                     std::optional<SplineExtraction> extraction)
    : structures_(std::move(structures)),
      spaces_(std::move(spaces)),
      terms_(std::move(terms)),
      rule_(rule),
      extraction_(std::move(extraction)) {}

Equations::Equations(std::vector<Structure> structures, GlobalSpaces spaces, EquationTerms terms,
                     const DomainRule& rule)
    : structures_(std::move(structures)),
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
  if (!global_spaces_.empty())
    return assemble_dense(structures_, global_spaces_, terms, rule_, {time, {}});
  LinearSystem system = assemble(structures_, spaces_, terms, rule_, {time, {}});
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
  if (!steady().symmetric) return stiffness() * coefficients - load(time);
  return stiffness().selfadjointView<Eigen::Lower>() * coefficients - load(time);
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
