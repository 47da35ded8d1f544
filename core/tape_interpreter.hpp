#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/operation_rules.hpp"
#include "core/tape_leaves.hpp"

namespace rfm {

/// One point, or bounds over a box: jets of any kind of number, all registers at the tape's highest
/// order. `leaf(instruction)` gives the jets of coordinates, parameters and sources.
template <class T, int N, int K, class Leaf>
Jet<T, N, K> interpret(const Tape::Program& program, int root, const Leaf& leaf) {
  using Number = Jet<T, N, K>;
  // Reused between calls, but taken away while in use: a source may evaluate a tape of its own.
  static thread_local std::vector<Number> cache;
  std::vector<Number> results = std::move(cache);
  const int last = program.root_instructions[root];
  if (static_cast<int>(results.size()) <= last) results.resize(last + 1);
  const Number none;
  // A number that is none has no derivatives either. Others need no further coefficients, unless
  // they lie outside the domain of what is made of them.
  const auto undefined = [&](double number) {
    Number jet = Leaves<N>::template zero<Number>(program);
    for (T& coefficient : jet.c) coefficient = T(number);
    return jet;
  };
  const auto constant_jet = [&](double number) {
    return std::isnan(number) ? undefined(number) : Number(number);
  };
  for (int i = 0; i <= last; ++i) {
    const Instruction& instruction = program.instructions[i];
    const auto operand = [&](int k) -> const Number& {
      return instruction.operands[k] < 0 ? none : results[instruction.operands[k]];
    };
    switch (instruction.operation) {
      case Operation::constant:
        results[i] = constant_jet(instruction.number);
        break;
      case Operation::coordinate:
      case Operation::parameter:
        results[i] = leaf(instruction);
        break;
      case Operation::source:
        results[i] = instruction.operands[0] < 0
                         ? leaf(instruction)
                         : composed_source<T, N, K>(program, instruction, results);
        break;
      case Operation::partial:
        results[i] = differentiate(operand(0), instruction.index);
        break;
      case Operation::scale:
        results[i] = scaled(T(instruction.number), operand(0));
        break;
      case Operation::offset:
        results[i] = operand(0);
        results[i].c[0] = results[i].c[0] + T(instruction.number);
        break;
      default:
        results[i] = apply_rule(instruction.operation, operand(0), operand(1), operand(2),
                                instruction.number);
        if constexpr (N == run_time && std::is_same_v<T, double>)
          if (std::isnan(results[i].c[0]) && results[i].size == 1)
            results[i] = undefined(results[i].c[0]);
    }
  }
  const Number result = results[last];
  cache = std::move(results);
  return result;
}

/// Instantiated in tape_interpreter_{1,2,3}d*.cpp and, at any order in any number of variables, in
/// tape_interpreter_dynamic.cpp.
template <int N>
struct Interpreter {
  using Leaf = Leaves<N>;

  static void jet(const Tape::Program& program, int root, const Point& point,
                  const OtherValues& others, std::span<double> coefficients) {
    at_order(program, [&]<int K>() {
      const auto jet = interpret<double, N, K>(program, root, [&](const Instruction& leaf) {
        return Leaf::template leaf_value<K>(program, leaf, point, others);
      });
      for (std::size_t i = 0; i < coefficients.size(); ++i)
        coefficients[i] = coefficient(jet, static_cast<int>(i));
    });
  }

  static FunctionBounds bounds(const Tape::Program& program, int root, const Box& box,
                               const OtherRanges& others) {
    const std::vector<int>& variables = program.variables.coordinates();
    std::array<double, maximum_variables> radius{};
    for (std::size_t i = 0; i < variables.size(); ++i) {
      const Interval range = Leaf::coordinate_range(variables[i], box, others);
      const double middle = range.middle();
      radius[i] = std::max(range.high - middle, middle - range.low) * (1 + 0x1p-50);
    }
    const TaylorBound::Frame frame(radius);
    return at_order(program, [&]<int K>() {
      const auto jet = interpret<TaylorBound, N, K>(program, root, [&](const Instruction& leaf) {
        return Leaf::template leaf_range<TaylorBound, K>(program, leaf, box, others);
      });
      FunctionBounds bounds{jet.c[0].range, {}, jet.c[0].smooth};
      // A register has meaning up to its own order only.
      const bool known = program.instructions[program.root_instructions[root]].order >= 1;
      for (int i = 0; i < static_cast<int>(variables.size()); ++i) {
        bounds.gradient[i] = Interval::entire();
        if (!known) continue;
        if constexpr (K != 0) {
          const TaylorBound slope = coefficient(jet, 1 + i);
          bounds.gradient[i] = slope.range;
          bounds.smooth = bounds.smooth && slope.smooth;
        }
      }
      return bounds;
    });
  }

  // Jets whose coefficients are Taylor models in the parameter of the line: bounds of second order
  // in its length.
  static LineBounds bounds(const Tape::Program& program, int root, const Line& line,
                           const Interval& t, const OtherRanges& others) {
    const double middle = t.middle();
    const TaylorBound::Frame frame(
        {std::max(t.high - middle, middle - t.low) * (1 + 0x1p-50), 0, 0});
    Box hull;
    hull.dimension = 3;
    for (int axis = 0; axis < 3; ++axis) {
      const Interval coordinate = line.coordinate(axis, t);
      hull.low[axis] = coordinate.low;
      hull.high[axis] = coordinate.high;
    }
    return at_order(program, [&]<int K>() -> LineBounds {
      if constexpr (K == 0) {
        return {Interval::entire(), Interval::entire(), false};
      } else {
        using Number = Jet<TaylorBound, N, K>;
        const auto coordinate_on_line = [&](int axis) {
          TaylorBound model;
          model.value = line.origin[axis] + middle * line.direction[axis];
          model.slope[0] = line.direction[axis];
          model.error =
              4e-16 * (std::fabs(line.origin[axis]) + std::fabs(middle * line.direction[axis]));
          model.range = {hull.low[axis], hull.high[axis]};
          Number number = Leaf::template coordinate<Number>(program, N == 1 ? 0 : axis, model);
          if constexpr (N == 1) number.c[1] = line.direction[axis];
          return number;
        };
        const Number jet =
            interpret<TaylorBound, N, K>(program, root, [&](const Instruction& leaf) -> Number {
              if (leaf.operation == Operation::coordinate && leaf.index < 3)
                return coordinate_on_line(leaf.index);
              if (N != 1 || leaf.operation != Operation::source)
                return Leaf::template leaf_range<TaylorBound, K>(program, leaf, hull, others);
              const FunctionBounds known = leaf.source->bounds(hull);
              Interval slope;
              for (int axis = 0; axis < 3; ++axis)
                slope = slope + Interval(line.direction[axis]) * known.gradient[axis];
              Number number = Leaf::template unknown<TaylorBound, K>(program);
              number.c[0] = Leaf::template of_range<TaylorBound>(known.value, known.smooth);
              number.c[1] = Leaf::template of_range<TaylorBound>(slope, known.smooth);
              return number;
            });
        TaylorBound slope = coefficient(jet, 1);
        if constexpr (N != 1) {
          slope = TaylorBound(line.direction[0]) * slope;
          for (int axis = 1; axis < program.variables.count(); ++axis)
            slope += TaylorBound(line.direction[axis]) * coefficient(jet, 1 + axis);
        }
        return {jet.c[0].range, slope.range, jet.c[0].smooth && slope.smooth};
      }
    });
  }

  static Interval value_bounds(const Tape::Program& program, int root, const Box& box,
                               const OtherRanges& others) {
    return at_order(program, [&]<int K>() {
      return interpret<Interval, N, K>(program, root,
                                       [&](const Instruction& leaf) {
                                         return Leaf::template leaf_range<Interval, K>(
                                             program, leaf, box, others);
                                       })
          .c[0];
    });
  }

 private:
  template <class Function>
  static auto at_order(const Tape::Program& program, const Function& function) {
    if constexpr (N == run_time) {
      return function.template operator()<run_time>();
    } else {
      switch (program.highest_order) {
        case 0:
          return function.template operator()<0>();
        case 1:
          return function.template operator()<1>();
        case 2:
          return function.template operator()<2>();
        case 3:
          return function.template operator()<3>();
        default:
          return function.template operator()<highest_compiled_order(N)>();
      }
    }
  }
};

template <int N>
void SinglePoint<N>::jet(const Tape::Program& program, int root, const Point& point,
                         const OtherValues& others, std::span<double> coefficients) {
  Interpreter<N>::jet(program, root, point, others, coefficients);
}

template <int N>
FunctionBounds SinglePoint<N>::bounds(const Tape::Program& program, int root, const Box& box,
                                      const OtherRanges& others) {
  return Interpreter<N>::bounds(program, root, box, others);
}

template <int N>
LineBounds SinglePoint<N>::bounds(const Tape::Program& program, int root, const Line& line,
                                  const Interval& range, const OtherRanges& others) {
  return Interpreter<N>::bounds(program, root, line, range, others);
}

template <int N>
Interval SinglePoint<N>::value_bounds(const Tape::Program& program, int root, const Box& box,
                                      const OtherRanges& others) {
  return Interpreter<N>::value_bounds(program, root, box, others);
}

}  // namespace rfm
