#pragma once

#include <algorithm>
#include <type_traits>
#include <vector>

#include "core/composed_source.hpp"
#include "core/error.hpp"
#include "core/tape_program.hpp"

namespace rfm {

/// A sampled field at a mapped point, or its bounds where the map leads: see
/// core/composed_source.hpp.
template <class T, int N, int K>
Jet<T, N, K> composed_source(const Tape::Program& program, const Instruction& instruction,
                             const std::vector<Jet<T, N, K>>& results) {
  constexpr bool is_dynamic = N == run_time;
  const JetShape& shape = is_dynamic
                              ? JetShape::get(program.variables.count(), program.highest_order)
                              : JetShape::get(std::max(N, 1), std::max(K, 0));
  std::vector<DynamicJet<T>> place;
  for (const int operand : instruction.operands) {
    if (operand < 0) break;
    place.emplace_back(shape);
    for (int i = 0; i < shape.size(); ++i) place.back().c[i] = coefficient(results[operand], i);
  }
  const DynamicJet<T> composed = jet_of_source<T>(*instruction.source, instruction.index, place);
  if constexpr (is_dynamic) {
    return composed;
  } else {
    Jet<T, N, K> jet;
    for (int i = 0; i < jet.size; ++i) jet.c[i] = coefficient(composed, i);
    return jet;
  }
}

/// What a tape is evaluated from at single points and over boxes, in N variables: the jets of
/// coordinates, parameters and sampled fields, or what is known of them over a box.
template <int N>
struct Leaves {
  // A jet of the tape's highest order, all zero.
  template <class Number>
  static Number zero(const Tape::Program& program) {
    if constexpr (N == run_time)
      return Number(JetShape::get(program.variables.count(), program.highest_order));
    else
      return Number();
  }

  // A coordinate with this value: one of the variables, or held.
  template <class Number>
  static Number coordinate(const Tape::Program& program, int variable, const auto& value) {
    Number jet = zero<Number>(program);
    jet.c[0] = value;
    if (variable >= 0 && jet.order() > 0) jet.c[1 + variable] = 1.0;
    return jet;
  }

  template <int K>
  static Jet<double, N, K> leaf_value(const Tape::Program& program, const Instruction& leaf,
                                      const Point& point, const OtherValues& others) {
    using Number = Jet<double, N, K>;
    const std::size_t index = leaf.index;
    if (leaf.operation == Operation::source) {
      Number jet = zero<Number>(program);
      evaluate_source(*leaf.source, program.variables, {&point[0], &point[1], &point[2]}, 1,
                      jet.order(), &jet.c[0], 1);
      return jet;
    }
    if (leaf.operation == Operation::parameter) {
      if (index >= others.parameters.size())
        throw InvalidArgument(missing_parameter(program, leaf.index, others.parameters.size()));
      return coordinate<Number>(program, -1, others.parameters[index]);
    }
    if (index > 3 && index - 4 >= others.further.size())
      throw InvalidArgument("the field needs coordinate number " + std::to_string(index) +
                            ", which is not given");
    return coordinate<Number>(program, leaf.variable,
                              index < 3    ? point[index]
                              : index == 3 ? others.time
                                           : others.further[index - 4]);
  }

  static Interval coordinate_range(int index, const Box& box, const OtherRanges& others) {
    if (index < 3) return box.interval(index);
    if (index == 3) return others.time;
    const std::size_t further = static_cast<std::size_t>(index) - 4;
    return further < others.further.size() ? others.further[further] : Interval::entire();
  }

  template <class T, int K>
  static Jet<T, N, K> leaf_range(const Tape::Program& program, const Instruction& leaf,
                                 const Box& box, const OtherRanges& others) {
    using Number = Jet<T, N, K>;
    if (leaf.operation == Operation::source) return source_bounds<T, K>(program, leaf, box);
    if (leaf.operation == Operation::parameter) {
      const bool known = leaf.index < static_cast<int>(others.parameters.size());
      return Number::constant(held<T>(known ? others.parameters[leaf.index] : Interval::entire()));
    }
    const Interval range = coordinate_range(leaf.index, box, others);
    if constexpr (std::is_same_v<T, TaylorBound>)
      if (leaf.variable >= 0)
        return coordinate<Number>(program, leaf.variable,
                                  TaylorBound::coordinate(range, leaf.variable));
    return coordinate<Number>(program, leaf.variable, held<T>(range));
  }

  // A function of which no bounds are known.
  template <class T, int K>
  static Jet<T, N, K> unknown(const Tape::Program& program) {
    auto jet = zero<Jet<T, N, K>>(program);
    for (T& coefficient : jet.c) coefficient = of_range<T>(Interval::entire(), false);
    return jet;
  }

  // What a source says of itself over a box.
  template <class T, int K>
  static Jet<T, N, K> source_bounds(const Tape::Program& program, const Instruction& leaf,
                                    const Box& box) {
    auto jet = unknown<T, K>(program);
    const FunctionBounds known = leaf.source->bounds(box);
    jet.c[0] = of_range<T>(known.value, known.smooth);
    if (jet.order() == 0) return jet;
    const std::vector<int>& variables = program.variables.coordinates();
    for (std::size_t i = 0; i < variables.size(); ++i)
      jet.c[1 + i] =
          variables[i] < 3 ? of_range<T>(known.gradient[variables[i]], known.smooth) : T(0.0);
    return jet;
  }

  template <class T>
  static T held(const Interval& range) {
    return range.is_point() ? T(range.low) : of_range<T>(range, true);
  }

  template <class T>
  static T of_range(const Interval& range, bool smooth) {
    if constexpr (std::is_same_v<T, TaylorBound>)
      return TaylorBound::of_range(range, smooth);
    else
      return range;
  }
};

}  // namespace rfm
