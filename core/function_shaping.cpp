#include "core/function_shaping.hpp"

#include <cmath>

#include "core/error.hpp"
#include "core/r_functions.hpp"

namespace rfm {

Field saturate(const Field& omega, const Saturation& saturation) {
  if (!(saturation.alpha >= 1 && saturation.beta > 0))
    throw InvalidArgument("saturation needs alpha >= 1 and beta > 0, got alpha = " +
                          std::to_string(saturation.alpha) +
                          ", beta = " + std::to_string(saturation.beta));
  const bool even = std::fmod(saturation.alpha, 2) == 0;
  const Field size = saturation.beta * (even ? omega : abs(omega));
  return omega / (1 + pow(size, saturation.alpha));
}

Field level_off(const Field& omega, double length) {
  if (!(length > 0))
    throw InvalidArgument("a function levels off at a positive length, got " +
                          std::to_string(length));
  return omega / sqrt(1.0 + omega * omega / (length * length));
}

Field cutoff(const Field& omega, double width) {
  if (!(width > 0))
    throw InvalidArgument("a cutoff has a positive width, got " + std::to_string(width));
  return exp(-pow(omega / width, 4));
}

Field cap(const Field& omega, const Field& gamma) { return conjunction(omega, gamma); }

Field plateau(const Field& omega, const PlateauRule& rule) {
  if (!(rule.width > 0) || rule.power < 1 || rule.power > 16)
    throw InvalidArgument(
        "a plateau needs a width greater than 0 and a power from 1 to 16, got width = " +
        std::to_string(rule.width) + ", power = " + std::to_string(rule.power));
  return 1 - pow(max(1 - omega / rule.width, 0.0), rule.power);
}

}  // namespace rfm
