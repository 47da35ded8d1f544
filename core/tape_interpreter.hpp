#pragma once

#include <vector>

#include "core/operation_rules.hpp"
#include "core/tape_program.hpp"

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
  for (int i = 0; i <= last; ++i) {
    const Instruction& instruction = program.instructions[i];
    const auto operand = [&](int k) -> const Number& {
      return instruction.operands[k] < 0 ? none : results[instruction.operands[k]];
    };
    switch (instruction.operation) {
      case Operation::constant:
        results[i] = Number(instruction.number);
        break;
      case Operation::coordinate:
      case Operation::parameter:
      case Operation::source:
        results[i] = leaf(instruction);
        break;
      case Operation::partial:
        results[i] = differentiate(operand(0), instruction.index);
        break;
      case Operation::integer_power:
        results[i] = integer_power(operand(0), instruction.index);
        break;
      case Operation::real_power:
        results[i] = real_power(operand(0), instruction.number);
        break;
      case Operation::scale:
        results[i] = scaled(T(instruction.number), operand(0));
        break;
      case Operation::offset:
        results[i] = operand(0);
        results[i].c[0] = results[i].c[0] + T(instruction.number);
        break;
      default:
        results[i] = apply_rule(instruction.operation, operand(0), operand(1), operand(2));
    }
  }
  const Number result = results[last];
  cache = std::move(results);
  return result;
}

/// What `SinglePoint` shares, instantiated in tape_interpreter_{1,2,3}d.cpp.
template <int N>
struct Interpreter {
  static double value(const Tape::Program& program, int root, const Point& point, double time,
                      Point* gradient) {
    return at_order(program, [&]<int K>() {
      const auto jet = interpret<double, N, K>(program, root, [&](const Instruction& leaf) {
        using Number = Jet<double, N, K>;
        if (leaf.operation == Operation::coordinate)
          return leaf.index == 3 ? Number(time) : Number::variable(leaf.index, point[leaf.index]);
        Number jet(std::nan(""));  // a parameter: only blocks carry values of parameters
        if (leaf.operation == Operation::source)
          leaf.source->evaluate({&point[0], &point[1], &point[2]}, 1, N, K, jet.c.data(), 1);
        return jet;
      });
      if constexpr (K >= 1)
        if (gradient)
          for (int axis = 0; axis < N; ++axis) (*gradient)[axis] = jet.c[1 + axis];
      return jet.c[0];
    });
  }

  static FunctionBounds bounds(const Tape::Program& program, int root, const Box& box,
                               double time) {
    std::array<double, 3> radius{};
    for (int axis = 0; axis < N; ++axis) {
      const double middle = 0.5 * (box.low[axis] + box.high[axis]);
      radius[axis] = std::max(box.high[axis] - middle, middle - box.low[axis]) * (1 + 0x1p-50);
    }
    const TaylorBound::Frame frame(radius);
    return at_order(program, [&]<int K>() {
      using Number = Jet<TaylorBound, N, K>;
      const auto jet = interpret<TaylorBound, N, K>(program, root, [&](const Instruction& leaf) {
        if (leaf.operation == Operation::coordinate)
          return leaf.index == 3
                     ? Number(time)
                     : Number::variable(leaf.index, TaylorBound::coordinate(
                                                        box.interval(leaf.index), leaf.index));
        return source_bounds<TaylorBound, K>(leaf, box);
      });
      FunctionBounds bounds{jet.c[0].range, {}, jet.c[0].smooth};
      // A register has meaning up to its own order only.
      const bool known = program.instructions[program.root_instructions[root]].order >= 1;
      for (int axis = 0; axis < N; ++axis) {
        bounds.gradient[axis] = Interval::entire();
        if constexpr (K >= 1) {
          if (!known) continue;
          bounds.gradient[axis] = jet.c[1 + axis].range;
          bounds.smooth = bounds.smooth && jet.c[1 + axis].smooth;
        }
      }
      return bounds;
    });
  }

  // Jets whose coefficients are Taylor models in the parameter of the line: bounds of second order
  // in its length.
  static LineBounds bounds(const Tape::Program& program, int root, const Line& line,
                           const Interval& t, double time) {
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
        const auto coordinate = [&](int axis) {
          const double value = line.origin[axis] + middle * line.direction[axis];
          TaylorBound model;
          model.value = value;
          model.slope[0] = line.direction[axis];
          model.error =
              4e-16 * (std::fabs(line.origin[axis]) + std::fabs(middle * line.direction[axis]));
          model.range = {hull.low[axis], hull.high[axis]};
          Number number = Number::constant(model);
          number.c[1 + (N == 1 ? 0 : axis)] = N == 1 ? line.direction[axis] : 1.0;
          return number;
        };
        const Number jet =
            interpret<TaylorBound, N, K>(program, root, [&](const Instruction& leaf) -> Number {
              if (leaf.operation == Operation::coordinate)
                return leaf.index == 3 ? Number(time) : coordinate(leaf.index);
              Number number = source_bounds<TaylorBound, K>(leaf, hull);
              if (N == 1 && leaf.operation == Operation::source) {
                const FunctionBounds known = leaf.source->bounds(hull);
                Interval slope;
                for (int axis = 0; axis < 3; ++axis)
                  slope = slope + Interval(line.direction[axis]) * known.gradient[axis];
                number.c[1] = of_range<TaylorBound>(slope, known.smooth);
              }
              return number;
            });
        TaylorBound slope = jet.c[1];
        if constexpr (N > 1) {
          slope = TaylorBound(line.direction[0]) * jet.c[1];
          for (int axis = 1; axis < N; ++axis)
            slope += TaylorBound(line.direction[axis]) * jet.c[1 + axis];
        }
        return {jet.c[0].range, slope.range, jet.c[0].smooth && slope.smooth};
      }
    });
  }

  static Interval value_bounds(const Tape::Program& program, int root, const Box& box,
                               double time) {
    return at_order(program, [&]<int K>() {
      using Number = Jet<Interval, N, K>;
      return interpret<Interval, N, K>(program, root,
                                       [&](const Instruction& leaf) {
                                         if (leaf.operation == Operation::coordinate)
                                           return leaf.index == 3
                                                      ? Number(time)
                                                      : Number::variable(leaf.index,
                                                                         box.interval(leaf.index));
                                         return source_bounds<Interval, K>(leaf, box);
                                       })
          .c[0];
    });
  }

 private:
  template <class Function>
  static auto at_order(const Tape::Program& program, const Function& function) {
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

  // What a source says of itself over a box; of a parameter nothing is known.
  template <class T, int K>
  static Jet<T, N, K> source_bounds(const Instruction& leaf, const Box& box) {
    Jet<T, N, K> jet;
    for (T& coefficient : jet.c) coefficient = of_range<T>(Interval::entire(), false);
    if (leaf.operation != Operation::source) return jet;
    const FunctionBounds known = leaf.source->bounds(box);
    jet.c[0] = of_range<T>(known.value, known.smooth);
    if constexpr (K >= 1)
      for (int axis = 0; axis < N; ++axis)
        jet.c[1 + axis] = of_range<T>(known.gradient[axis], known.smooth);
    return jet;
  }

  template <class T>
  static T of_range(const Interval& range, bool smooth) {
    if constexpr (std::is_same_v<T, TaylorBound>)
      return TaylorBound::of_range(range, smooth);
    else
      return range;
  }
};

template <int N>
double SinglePoint<N>::value(const Tape::Program& program, int root, const Point& point,
                             double time, Point* gradient) {
  return Interpreter<N>::value(program, root, point, time, gradient);
}

template <int N>
FunctionBounds SinglePoint<N>::bounds(const Tape::Program& program, int root, const Box& box,
                                      double time) {
  return Interpreter<N>::bounds(program, root, box, time);
}

template <int N>
LineBounds SinglePoint<N>::bounds(const Tape::Program& program, int root, const Line& line,
                                  const Interval& range, double time) {
  return Interpreter<N>::bounds(program, root, line, range, time);
}

template <int N>
Interval SinglePoint<N>::value_bounds(const Tape::Program& program, int root, const Box& box,
                                      double time) {
  return Interpreter<N>::value_bounds(program, root, box, time);
}

}  // namespace rfm
