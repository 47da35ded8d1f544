#include "problems/output/colour_map.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>

#include "core/error.hpp"

namespace rfm {
namespace {

struct Oklab {
  double lightness, a, b;
};

double to_linear(double part) {
  return part <= 0.04045 ? part / 12.92 : std::pow((part + 0.055) / 1.055, 2.4);
}
double from_linear(double part) {
  return part <= 0.0031308 ? 12.92 * part : 1.055 * std::pow(part, 1 / 2.4) - 0.055;
}

Oklab oklab(const Colour& colour) {
  const double r = to_linear(colour.red), g = to_linear(colour.green), b = to_linear(colour.blue);
  const double l = std::cbrt(0.4122214708 * r + 0.5363325363 * g + 0.0514459929 * b);
  const double m = std::cbrt(0.2119034982 * r + 0.6806995451 * g + 0.1073969566 * b);
  const double s = std::cbrt(0.0883024619 * r + 0.2817188376 * g + 0.6299787005 * b);
  return {0.2104542553 * l + 0.7936177850 * m - 0.0040720468 * s,
          1.9779984951 * l - 2.4285922050 * m + 0.4505937099 * s,
          0.0259040371 * l + 0.7827717662 * m - 0.8086757660 * s};
}

Colour srgb(const Oklab& lab) {
  const double l = std::pow(lab.lightness + 0.3963377774 * lab.a + 0.2158037573 * lab.b, 3);
  const double m = std::pow(lab.lightness - 0.1055613458 * lab.a - 0.0638541728 * lab.b, 3);
  const double s = std::pow(lab.lightness - 0.0894841775 * lab.a - 1.2914855480 * lab.b, 3);
  const auto part = [](double linear) { return std::clamp(from_linear(linear), 0.0, 1.0); };
  return {part(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
          part(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
          part(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s)};
}

constexpr Colour hex(unsigned code) {
  return {(code >> 16 & 255) / 255.0, (code >> 8 & 255) / 255.0, (code & 255) / 255.0};
}

// Equally spaced along the map.
constexpr std::array viridis = {hex(0x440154), hex(0x482878), hex(0x3E4A89), hex(0x31688E),
                                hex(0x26828E), hex(0x1F9E89), hex(0x35B779), hex(0x6DCD59),
                                hex(0xB4DE2C), hex(0xFDE725)};
// Lightness 0.41, 0.68 and 0.96 in Oklab, the same on both sides.
constexpr std::array blue_red = {hex(0x204594), hex(0x6B9DDA), hex(0xF2F2F2), hex(0xDD7E68),
                                 hex(0x881A27)};

std::span<const Colour> controls(ColourMap map) {
  return map == ColourMap::uniform ? std::span<const Colour>(viridis) : std::span(blue_red);
}

}  // namespace

double lightness(const Colour& colour) { return oklab(colour).lightness; }

Colour colour_at(ColourMap map, double t) {
  const std::span<const Colour> colours = controls(map);
  const int intervals = static_cast<int>(colours.size()) - 1;
  const double position = std::clamp(t, 0.0, 1.0) * intervals;
  const int i = std::min(static_cast<int>(position), intervals - 1);
  const double weight = position - i;
  if (weight == 0) return colours[i];
  if (weight == 1) return colours[i + 1];
  const Oklab a = oklab(colours[i]), b = oklab(colours[i + 1]);
  return srgb({a.lightness + weight * (b.lightness - a.lightness), a.a + weight * (b.a - a.a),
               a.b + weight * (b.b - a.b)});
}

ColourScale::ColourScale(ColourMap map, double low, double high)
    : map_(map), low_(low), high_(high) {
  if (!std::isfinite(low) || !std::isfinite(high) || low > high)
    throw InvalidArgument("the range of a colour scale needs finite bounds, low <= high");
  // Differences within rounding are no range: they would be drawn as noise.
  const double least = 1e-12 * std::max(std::abs(low), std::abs(high));
  if (high_ - low_ <= least) {
    const double half = std::max(std::abs(low), std::abs(high)) > 0 ? 0.5 * std::abs(low) : 0.5;
    low_ = low - half;
    high_ = high + half;
  }
  constexpr int steps = 1024;
  for (int i = 0; i <= steps; ++i) table_.push_back(colour_at(map, double(i) / steps));
}

Colour ColourScale::operator()(double value) const {
  if (std::isnan(value)) return {0.5, 0.5, 0.5};
  const int steps = static_cast<int>(table_.size()) - 1;
  const double position = std::clamp((value - low_) / (high_ - low_), 0.0, 1.0) * steps;
  const int i = std::min(static_cast<int>(position), steps - 1);
  return mixed(table_[i], table_[i + 1], position - i);
}

ValueRange symmetric_about_zero(const ValueRange& range) {
  const double bound = std::max(std::abs(range.low), std::abs(range.high));
  return {-bound, bound};
}

}  // namespace rfm
