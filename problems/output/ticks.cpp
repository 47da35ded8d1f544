#include "problems/output/ticks.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

// 1, 2 or 5 · 10ᵏ nearest to `step` on a logarithmic scale.
double nice_step(double step) {
  const double power = std::pow(10.0, std::floor(std::log10(step)));
  const double digit = step / power;
  if (digit < std::sqrt(2.0)) return power;
  if (digit < std::sqrt(10.0)) return 2 * power;
  if (digit < std::sqrt(50.0)) return 5 * power;
  return 10 * power;
}

std::vector<std::string> labels_of(const std::vector<double>& values, double step) {
  double largest = 0;
  for (const double value : values) largest = std::max(largest, std::abs(value));
  const int exponent = largest > 0 ? static_cast<int>(std::floor(std::log10(largest) + 1e-9)) : 0;
  const bool scientific = exponent >= 6 || exponent < -3;
  const double unit = scientific ? std::pow(10.0, exponent) : 1.0;
  const int decimals =
      std::clamp(-static_cast<int>(std::floor(std::log10(step / unit) + 1e-9)), 0, 15);
  std::vector<std::string> labels;
  for (const double value : values) {
    if (value == 0)
      labels.push_back("0");
    else if (scientific)
      labels.push_back(fmt::format("{:.{}f}e{}", value / unit, decimals, exponent));
    else
      labels.push_back(fmt::format("{:.{}f}", value, decimals));
  }
  return labels;
}

// 0.001, 5, 200000, 1e6, 2e-7.
std::string decade_label(double value) {
  const int exponent = static_cast<int>(std::floor(std::log10(value) + 1e-9));
  if (exponent >= -3 && exponent < 6) return fmt::format("{:g}", value);
  return fmt::format("{:.0f}e{}", value / std::pow(10.0, exponent), exponent);
}

void check_range(double low, double high) {
  if (!std::isfinite(low) || !std::isfinite(high) || !(low < high))
    throw InvalidArgument("ticks need a range low < high of finite numbers");
}

}  // namespace

Ticks nice_ticks(double low, double high, int count) {
  check_range(low, high);
  if (count < 1) throw InvalidArgument("ticks need a positive count");
  Ticks ticks;
  ticks.step = nice_step((high - low) / count);
  // Bounds that are multiples up to rounding have ticks.
  const double first = std::ceil(low / ticks.step - 1e-9),
               last = std::floor(high / ticks.step + 1e-9);
  for (double i = first; i <= last; ++i) ticks.values.push_back(i == 0 ? 0.0 : i * ticks.step);
  ticks.labels = labels_of(ticks.values, ticks.step);
  return ticks;
}

Ticks decade_ticks(double low, double high) {
  check_range(low, high);
  if (!(low > 0)) throw InvalidArgument("decades need positive bounds");
  const int first = static_cast<int>(std::floor(std::log10(low) - 1e-9)),
            last = static_cast<int>(std::ceil(std::log10(high) + 1e-9));
  const auto collect = [&](std::vector<double> digits) {
    std::vector<double> values;
    for (int exponent = first; exponent <= last; ++exponent)
      for (const double digit : digits) {
        const double value = digit * std::pow(10.0, exponent);
        if (value >= low * (1 - 1e-9) && value <= high * (1 + 1e-9)) values.push_back(value);
      }
    return values;
  };
  Ticks ticks;
  ticks.step = 10;
  ticks.values = collect({1});
  if (ticks.values.size() < 2) ticks.values = collect({1, 2, 5});
  for (const double value : ticks.values) ticks.labels.push_back(decade_label(value));
  return ticks;
}

}  // namespace rfm
