#include "problems/pictures/missing_values.hpp"

#include <fmt/format.h>

#include "core/diagnosis.hpp"

namespace rfm {

std::string missing_values_text(const std::string& effect, const MissingValues& missing,
                                const ShownField& shown, int dimension) {
  std::string cause;
  for (const Field& component : shown.components)
    if (cause.empty()) cause = diagnosis_suffix(component, missing.first, dimension);
  return fmt::format("{}, where {} is not a finite number, as at the point {}{}", effect,
                     shown.name, point_text(missing.first, dimension), cause);
}

}  // namespace rfm
