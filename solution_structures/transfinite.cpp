#include "solution_structures/transfinite.hpp"

#include "core/error.hpp"

namespace rfm {

Field transfinite_interpolant(const std::vector<TransfiniteDatum>& data) {
  if (data.empty()) throw InvalidArgument("transfinite interpolation needs at least one datum");
  if (data.size() == 1) return data[0].value;
  // Π_{j≠i} from products of those before and those after i: linear in the number of sets.
  const std::size_t count = data.size();
  std::vector<Field> before(count + 1, 1.0), after(count + 1, 1.0);
  for (std::size_t i = 0; i < count; ++i)
    before[i + 1] = before[i] * pow(data[i].distance, data[i].exponent);
  for (std::size_t i = count; i-- > 0;)
    after[i] = after[i + 1] * pow(data[i].distance, data[i].exponent);
  Field numerator = 0.0, denominator = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const Field others = before[i] * after[i + 1];
    numerator = numerator + product_or_nothing(data[i].value, others);
    denominator = denominator + others;
  }
  return numerator.is_constant(0) ? numerator : numerator / denominator;
}

}  // namespace rfm
