#include "solution_structures/undetermined.hpp"

#include <array>
#include <cmath>
#include <limits>
#include <string>

#include "core/composition.hpp"
#include "core/error.hpp"
#include "core/field_source.hpp"
#include "core/graph_walk.hpp"

namespace rfm {
namespace {

constexpr int largest_count = 64;

class UndeterminedSource : public FieldSource {
 public:
  explicit UndeterminedSource(int unknown) : unknown_(unknown) {}
  int unknown() const { return unknown_; }

  void evaluate(const std::array<const double*, 3>&, int count, int variables, int order,
                double* jets, int stride) const override {
    for (int c = 0; c < jet_size(variables, order); ++c)
      for (int i = 0; i < count; ++i) jets[c * stride + i] = std::nan("");
  }
  FunctionBounds bounds(const Box&) const override {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    FunctionBounds any;
    any.value = {-infinity, infinity};
    any.gradient.fill(any.value);
    any.smooth = false;
    return any;
  }
  std::vector<double> breakpoints(int) const override { return {}; }
  Box valid() const override {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    return {3, {-infinity, -infinity, -infinity}, {infinity, infinity, infinity}};
  }

 private:
  int unknown_;
};

}  // namespace

Field undetermined_function(int unknown) {
  // One source each, made once: leaves are the same function where their sources are.
  static const std::vector<Field> functions = [] {
    std::vector<Field> all;
    for (int k = 0; k < largest_count; ++k)
      all.push_back(field(std::make_shared<UndeterminedSource>(k)));
    return all;
  }();
  if (unknown < 0 || unknown >= largest_count)
    throw InvalidArgument("undetermined functions are numbered from 0 to 63, got " +
                          std::to_string(unknown));
  return functions[static_cast<std::size_t>(unknown)];
}

std::optional<int> undetermined_index(const Field::Node& node) {
  if (node.operation != Operation::source) return {};
  const auto* source = dynamic_cast<const UndeterminedSource*>(node.source.get());
  return source ? std::optional<int>(source->unknown()) : std::nullopt;
}

bool has_undetermined(const Field& formula) {
  return walked<bool>(
      formula, [](const Field& leaf) { return undetermined_index(leaf.node()).has_value(); },
      [](const Field& field, const std::vector<bool>& arguments) {
        bool any = undetermined_index(field.node()).has_value();
        for (const bool argument : arguments) any = any || argument;
        return any;
      });
}

Field with_functions(const Field& formula, std::span<const Field> functions) {
  return with_leaves(formula, [&](const Field& leaf) -> Field {
    const std::optional<int> unknown = undetermined_index(leaf.node());
    if (!unknown) return leaf;
    if (*unknown >= static_cast<int>(functions.size()))
      throw InvalidArgument("a formula uses undetermined function " + std::to_string(*unknown) +
                            ", and " + std::to_string(functions.size()) + " are given");
    return functions[static_cast<std::size_t>(*unknown)];
  });
}

}  // namespace rfm
