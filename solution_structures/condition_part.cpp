#include "solution_structures/condition_part.hpp"

#include "core/error.hpp"
#include "solution_structures/transfinite.hpp"

namespace rfm {

Structure transfinite(const std::vector<ConditionPart>& parts) {
  if (parts.empty()) throw InvalidArgument("transfinite interpolation needs at least one part");
  if (parts.size() == 1) return parts[0].polynomial;
  Structure sum;
  std::vector<TransfiniteDatum> formula;
  Structure::Call call{{}, "transfinite", {}};
  const std::vector<Field> weights = [&] {
    std::vector<TransfiniteDatum> distances;
    for (const ConditionPart& part : parts) distances.push_back({0.0, part.omega, part.exponent});
    return transfinite_weights(distances);
  }();
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const ConditionPart& part = parts[i];
    sum = sum + weights[i] * part.polynomial;
    formula.push_back({part.polynomial.formula(), part.omega, part.exponent});
    call.arguments.insert(call.arguments.end(),
                          {part.polynomial.formula(), part.omega, double(part.exponent)});
  }
  return sum.written_as(transfinite_interpolant(formula), call);
}

Field remainder_factor(const std::vector<ConditionPart>& parts) {
  Field product = 1.0;
  for (const ConditionPart& part : parts) product = product * pow(part.omega, part.exponent);
  return product;
}

Structure mixed(const std::vector<ConditionPart>& parts, const Structure& psi,
                const std::optional<Field>& factor) {
  return transfinite(parts) + factor.value_or(remainder_factor(parts)) * psi;
}

Structure corrected(const Structure& w, const std::vector<NaturalPart>& natural,
                    const Structure& psi, const std::optional<PrescribedValues>& values) {
  Structure u = w;
  Field remainder = 0.0;
  for (const NaturalPart& part : natural) {
    const Field square = pow(part.omega, 2);
    Field share = part.cutoff;
    for (const NaturalPart& other : natural)
      if (&other != &part) share = share * (pow(other.omega, 2) / (pow(other.omega, 2) + square));
    Field correction = share * part.omega;
    if (values) {
      const Field far = pow(values->distance, 2);
      correction = correction * (far / (far + square));
    }
    u = u - correction * part.excess;
    remainder = remainder + share * square;
  }
  return u + (values ? values->omega * remainder : remainder) * psi;
}

}  // namespace rfm
