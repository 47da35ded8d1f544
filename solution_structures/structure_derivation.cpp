#include "solution_structures/structure_derivation.hpp"

#include "solution_structures/condition_part.hpp"
#include "solution_structures/normal_conditions.hpp"
#include "solution_structures/plate_conditions.hpp"

namespace rfm {
namespace {

bool same_value(const Field& a, const Field& b) {
  return a.same_as(b) || (a.is_constant() && b.is_constant() && a.constant() == b.constant());
}

/// Conditions become parts one after the other; undetermined functions are numbered as they come.
class Derivation {
 public:
  explicit Derivation(const DerivationOptions& options) : options_(options) {}

  void add(const StructureCondition& piece) {
    std::visit([&](const auto& condition) { add(condition, piece.omega); }, piece.condition);
  }

  Structure result() {
    if (parts_.empty()) return Structure::undetermined(0);
    return mixed(parts_, Structure::undetermined(unknowns_), options_.remainder);
  }

 private:
  void add(const ValueCondition& condition, const Field& omega) {
    for (const std::size_t i : values_) {
      ConditionPart& part = parts_[i];
      if (!same_value(part.polynomial.inhomogeneous(), condition.value)) continue;
      part.omega = part.omega * omega;
      return;
    }
    values_.push_back(parts_.size());
    parts_.push_back({condition.value, omega, 1});
  }
  void add(const SlopeCondition& condition, const Field& omega) {
    parts_.push_back(normal_derivative_part(value(), omega, condition.slope, options_.dimension));
  }
  void add(const RobinCondition& condition, const Field& omega) {
    parts_.push_back(
        robin_part(value(), omega, condition.a, condition.b, condition.c, options_.dimension));
  }
  void add(const ObliqueCondition& condition, const Field& omega) {
    parts_.push_back(oblique_part(value(), omega, condition.direction, condition.a, condition.c,
                                  options_.length));
  }
  void add(const ClampedCondition& condition, const Field& omega) {
    parts_.push_back(
        clamped_part(omega, condition.deflection, condition.rotation, options_.dimension));
  }
  void add(const SupportedCondition& condition, const Field& omega) {
    parts_.push_back(simply_supported_part(omega, condition.deflection, condition.moment,
                                           condition.poisson_ratio, options_.dimension,
                                           Structure::undetermined(unknowns_++)));
  }

  // Ψ for the value where none is prescribed: one for all parts, numbered when it is first needed.
  const Structure& value() {
    if (!value_) value_ = Structure::undetermined(unknowns_++);
    return *value_;
  }

  const DerivationOptions& options_;
  std::vector<ConditionPart> parts_;
  std::vector<std::size_t> values_;  // places of those that prescribe a value alone
  std::optional<Structure> value_;
  int unknowns_ = 0;
};

}  // namespace

Structure derived_structure(const std::vector<StructureCondition>& conditions,
                            const DerivationOptions& options) {
  Derivation derivation(options);
  for (const StructureCondition& condition : conditions) derivation.add(condition);
  return derivation.result();
}

}  // namespace rfm
