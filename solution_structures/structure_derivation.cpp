#include "solution_structures/structure_derivation.hpp"

#include <algorithm>

#include "core/function_shaping.hpp"
#include "solution_structures/condition_part.hpp"

namespace rfm {
namespace {

bool same_value(const Field& a, const Field& b) {
  return a.same_as(b) || (a.is_constant() && b.is_constant() && a.constant() == b.constant());
}

/// Conditions become parts one after the other; undetermined functions are numbered as they come.
class Derivation {
 public:
  Derivation(const std::vector<StructureCondition>& conditions, const DerivationOptions& options)
      : options_(options) {
    for (const StructureCondition& piece : conditions)
      std::visit([&](const auto& condition) { add(condition, piece.omega); }, piece.condition);
  }

  /// (7.12).
  Structure joined() {
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
  void add(const RobinData& data, const Field& omega) {
    parts_.push_back(robin_part(value(), omega, data, options_.dimension));
  }
  void add(const ObliqueData& data, const Field& omega) {
    parts_.push_back(oblique_part(value(), omega, data));
  }
  void add(const ClampedCondition& condition, const Field& omega) {
    parts_.push_back(
        clamped_part(omega, condition.deflection, condition.rotation, options_.dimension));
  }
  void add(const SupportData& data, const Field& omega) {
    parts_.push_back(simply_supported_part(omega, data, options_.dimension,
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

bool is_value(const StructureCondition& piece) {
  return std::holds_alternative<ValueCondition>(piece.condition);
}
bool is_of_first_order(const StructureCondition& piece) {
  return std::holds_alternative<SlopeCondition>(piece.condition) ||
         std::holds_alternative<RobinData>(piece.condition) ||
         std::holds_alternative<ObliqueData>(piece.condition);
}

// By how much the structure `w` misses a condition of first order.
Structure excess(const Structure& w, const StructureCondition& piece, int dimension) {
  if (const auto* slope = std::get_if<SlopeCondition>(&piece.condition))
    return normal_derivative_excess(w, piece.omega, slope->slope, dimension);
  if (const auto* robin = std::get_if<RobinData>(&piece.condition))
    return robin_excess(w, piece.omega, *robin, dimension);
  return oblique_excess(w, piece.omega, std::get<ObliqueData>(piece.condition));
}

Structure corrected_near_boundary(const std::vector<StructureCondition>& conditions,
                                  const DerivationOptions& options) {
  std::vector<StructureCondition> values;
  std::optional<Field> omega;
  for (const StructureCondition& piece : conditions) {
    if (!is_value(piece)) continue;
    values.push_back(piece);
    omega = omega ? *omega * piece.omega : piece.omega;
  }
  const Structure w = Derivation(values, options).joined();
  std::vector<NaturalPart> natural;
  for (const StructureCondition& piece : conditions)
    if (!is_value(piece))
      natural.push_back(
          {excess(w, piece, options.dimension), piece.omega, cutoff(piece.omega, *options.reach)});
  std::optional<PrescribedValues> prescribed;
  if (omega) prescribed = {*omega, *omega};
  return corrected(w, natural, Structure::undetermined(1), prescribed);
}

}  // namespace

Structure derived_structure(const std::vector<StructureCondition>& conditions,
                            const DerivationOptions& options) {
  if (options.reach && std::ranges::any_of(conditions, is_of_first_order) &&
      std::ranges::all_of(conditions, [](const StructureCondition& piece) {
        return is_value(piece) || is_of_first_order(piece);
      }))
    return corrected_near_boundary(conditions, options);
  return Derivation(conditions, options).joined();
}

}  // namespace rfm
