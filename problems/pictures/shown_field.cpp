#include "problems/pictures/shown_field.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>

#include "core/error.hpp"
#include "problems/output/ticks.hpp"
#include "problems/result_scope.hpp"
#include "solvers/integrate.hpp"

namespace rfm {
namespace {

// A field that is constant but for rounding is constant: a scale over its noise has no numbers. On
// a surface where it vanishes only its size elsewhere tells what rounding is.
ValueRange without_rounding(const ValueRange& range, double elsewhere) {
  constexpr double noise = 1e-12;
  const double size = std::max({std::fabs(range.low), std::fabs(range.high), elsewhere});
  if (range.high - range.low > noise * size) return range;
  double middle = range.low + 0.5 * (range.high - range.low);
  if (std::fabs(middle) <= noise * elsewhere) middle = 0;
  return {middle, middle};
}

ValueRange extended(const ValueRange& range) {
  const double size = range.high - range.low;
  if (!(size > 0)) return range;
  const double step = nice_ticks(range.low, range.high, 8).step, little = 0.005 * size;
  const double low = step * std::floor(range.low / step),
               high = step * std::ceil(range.high / step);
  return {range.low - low < little ? low : range.low,
          high - range.high < little ? high : range.high};
}

}  // namespace

std::string shown_title(const Problem& problem) {
  return problem.title.empty() ? std::filesystem::path(problem.file).stem().string()
                               : problem.title;
}

ShownField shown_field(const Problem& problem, const ScalarSolution& solution,
                       const Picture& picture) {
  ExpressionScope scope = problem.scope;
  define_results(scope, solution.results);
  ShownField shown;
  shown.components = evaluate(Expression(picture.field), scope).components;
  shown.name = shown.is_vector() ? "|" + picture.field + "|" : picture.field;
  shown.title = shown_title(problem);
  try {
    for (const Field& component : shown.components)
      shown.size = std::max(shown.size, maximum(component, solution.rule));
  } catch (const ComputationError&) {
    shown.size = 0;  // pictures leave out what is not a number, and say so
  }
  return shown;
}

ValueRange shown_range(const Picture& picture, const ValueRange& values, double size) {
  const ValueRange data = without_rounding(values, size);
  if (picture.range) return {picture.range->first, picture.range->second};
  if (picture.colours == Picture::Colours::diverging) return extended(symmetric_about_zero(data));
  return extended(data);
}

}  // namespace rfm
