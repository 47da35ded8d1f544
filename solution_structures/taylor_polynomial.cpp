#include "solution_structures/taylor_polynomial.hpp"

#include "core/error.hpp"

namespace rfm {

ConditionPart taylor_part(const std::vector<Field>& inward_derivatives, const Field& omega,
                          int dimension) {
  if (inward_derivatives.empty()) throw InvalidArgument("a Taylor polynomial needs a value");
  Structure sum;
  double factorial = 1;
  const int order = static_cast<int>(inward_derivatives.size()) - 1;
  for (int k = 0; k <= order; ++k) {
    if (k > 1) factorial *= k;
    const Field& f = inward_derivatives[static_cast<std::size_t>(k)];
    const Structure coefficient = k < order ? normalized(f, omega, dimension) : Structure(f);
    sum = sum + (pow(omega, k) / factorial) * coefficient;
  }
  return {sum, omega, order + 1};
}

}  // namespace rfm
