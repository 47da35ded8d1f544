#include <algorithm>
#include <numeric>
#include <string>

#include "core/error.hpp"
#include "core/tape_program.hpp"

namespace rfm {

Variables::Variables(int dimension) : coordinates_(std::max(dimension, 0)), rest_vanishes_(true) {
  if (dimension < 1 || dimension > 3)
    throw InvalidArgument("space has 1 to 3 dimensions, got " + std::to_string(dimension));
  std::iota(coordinates_.begin(), coordinates_.end(), 0);
}

Variables::Variables(std::initializer_list<int> coordinates)
    : Variables(std::vector<int>(coordinates)) {}

Variables::Variables(std::vector<int> coordinates) : coordinates_(std::move(coordinates)) {
  if (coordinates_.empty() || coordinates_.size() > maximum_variables)
    throw InvalidArgument("jets have 1 to 4 variables, got " + std::to_string(coordinates_.size()));
  for (std::size_t i = 0; i < coordinates_.size(); ++i)
    if (coordinates_[i] < 0 || find(coordinates_[i]) != static_cast<int>(i))
      throw InvalidArgument("the variables of jets are different coordinates, numbered from 0");
}

int Variables::find(int coordinate) const {
  const auto place = std::ranges::find(coordinates_, coordinate);
  return place == coordinates_.end() ? -1 : static_cast<int>(place - coordinates_.begin());
}

bool Variables::are_leading() const {
  for (int i = 0; i < count(); ++i)
    if (coordinates_[i] != i || i > 2) return false;
  return true;
}

void evaluate_source(const FieldSource& source, const Variables& variables,
                     const std::array<const double*, 3>& coordinates, int count, int order,
                     double* jets, int stride) {
  if (variables.are_leading())
    return source.evaluate(coordinates, count, variables.count(), order, jets, stride);
  // Jets in as many of x, y, z as are needed, of which those along the variables are taken.
  int axes = 0;
  for (const int coordinate : variables.coordinates())
    if (coordinate < 3) axes = std::max(axes, coordinate + 1);
  const int needed = axes > 0 ? order : 0;
  axes = std::max(axes, 1);
  // Taken away while in use: a source may evaluate a tape of its own.
  static thread_local std::vector<double> cache;
  std::vector<double> own = std::move(cache);
  own.resize(static_cast<std::size_t>(jet_size(axes, needed)) * count);
  source.evaluate(coordinates, count, axes, needed, own.data(), count);
  const JetShape& shape = JetShape::get(variables.count(), order);
  for (int i = 0; i < shape.size(); ++i) {
    MultiIndex along_axes{};
    bool varies = true;
    for (int v = 0; v < variables.count(); ++v) {
      const int coordinate = variables.coordinates()[v], power = shape.exponent(i)[v];
      if (coordinate < 3)
        along_axes[coordinate] = static_cast<std::uint8_t>(power);
      else
        varies = varies && power == 0;
    }
    double* const row = jets + static_cast<std::ptrdiff_t>(i) * stride;
    if (varies)
      std::copy_n(own.data() + static_cast<std::ptrdiff_t>(jet_index(axes, along_axes)) * count,
                  count, row);
    else
      std::fill_n(row, count, 0.0);
  }
  cache = std::move(own);
}

}  // namespace rfm
