#include "solution_structures/transfinite.hpp"

#include "core/error.hpp"

namespace rfm {
namespace {

// Π_{j≠i} ω_j^{μ_j} from products of those before and those after i: linear in the number of sets.
std::vector<Field> products_of_others(const std::vector<TransfiniteDatum>& data) {
  const std::size_t count = data.size();
  std::vector<Field> before(count + 1, 1.0), after(count + 1, 1.0), others;
  for (std::size_t i = 0; i < count; ++i)
    before[i + 1] = before[i] * pow(data[i].distance, data[i].exponent);
  for (std::size_t i = count; i-- > 0;)
    after[i] = after[i + 1] * pow(data[i].distance, data[i].exponent);
  for (std::size_t i = 0; i < count; ++i) others.push_back(before[i] * after[i + 1]);
  return others;
}

Field sum_of(const std::vector<Field>& fields) {
  Field sum = 0.0;
  for (const Field& field : fields) sum = sum + field;
  return sum;
}

void require_data(const std::vector<TransfiniteDatum>& data) {
  if (data.empty()) throw InvalidArgument("transfinite interpolation needs at least one datum");
}

}  // namespace

Field transfinite_interpolant(const std::vector<TransfiniteDatum>& data) {
  require_data(data);
  if (data.size() == 1) return data[0].value;
  const std::vector<Field> others = products_of_others(data);
  Field numerator = 0.0;
  for (std::size_t i = 0; i < data.size(); ++i)
    numerator = numerator + product_or_nothing(data[i].value, others[i]);
  return numerator.is_constant(0) ? numerator : numerator / sum_of(others);
}

std::vector<Field> transfinite_weights(const std::vector<TransfiniteDatum>& data) {
  require_data(data);
  const std::vector<Field> others = products_of_others(data);
  const Field sum = sum_of(others);
  std::vector<Field> weights;
  for (const Field& product : others) weights.push_back(product / sum);
  return weights;
}

}  // namespace rfm
