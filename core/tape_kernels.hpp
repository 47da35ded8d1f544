#pragma once

#include "core/dynamic_jet.hpp"
#include "core/operation_rules.hpp"
#include "core/tape_program.hpp"

namespace rfm {

/// Number of variables and order of the jets that a kernel works on: known when it is compiled,
template <int N, int K>
struct KernelShape {
  using BatchJet = Jet<Batch, N, K>;
  static constexpr bool is_compiled = true;
  explicit KernelShape(const Step&) {}
  static constexpr int variables() { return N; }
  static constexpr int order() { return K; }
  static constexpr int size() { return BatchJet::size; }
  static const MultiIndex& exponent(int i) { return JetTables<N, K>::exponents[i]; }
  static int raised(int axis, int i) { return jet_index(N, exponent(i) + unit_index(axis)); }
  static BatchJet zero() { return {}; }
};
/// or from the step.
template <>
struct KernelShape<run_time, run_time> {
  using BatchJet = DynamicJet<Batch>;
  static constexpr bool is_compiled = false;
  const JetShape& shape;
  explicit KernelShape(const JetShape& shape) : shape(shape) {}
  explicit KernelShape(const Step& step) : KernelShape(JetShape::get(step.variables, step.order)) {}
  int variables() const { return shape.variables(); }
  int order() const { return shape.order(); }
  int size() const { return shape.size(); }
  const MultiIndex& exponent(int i) const { return shape.exponent(i); }
  int raised(int axis, int i) const { return shape.raised(axis, i); }
  BatchJet zero() const { return BatchJet(shape); }
};

/// Kernels for N variables and order K, instantiated in tape_kernels_{1,2,3}d*.cpp and, for any
/// number and order, in tape_kernels_dynamic.cpp: load the jets of a few points, apply the rule,
/// store, for all points of the block.
template <int N, int K>
struct Kernels {
  using Shape = KernelShape<N, K>;
  using BatchJet = typename Shape::BatchJet;
  static constexpr int width = static_cast<int>(Batch::size());
  static constexpr int block = Tape::block_size;

  static BatchJet load(const Shape& shape, const Register& from, const double* memory, int lane) {
    BatchJet jet = shape.zero();
    const auto read = [&](int first, int last, const Part& part) {
      const double* const place = memory + part.offset() + lane * part.stride();
      for (int i = first; i < last; ++i)
        jet.c[i].copy_from(place + (i - first) * block, std::experimental::element_aligned);
    };
    const int first_order = 1 + shape.variables();
    read(0, 1, from.value);
    if (shape.order() >= 1) read(1, first_order, from.gradient);
    if (shape.order() >= 2) read(first_order, shape.size(), from.rest);
    return jet;
  }
  static void store(const Shape& shape, const BatchJet& jet, double* to) {
    for (int i = 0; i < shape.size(); ++i)
      coefficient(jet, i).copy_to(to + i * block, std::experimental::element_aligned);
  }

  template <Operation operation, int arity>
  static void apply(const Step& step, double* memory, int count) {
    const Shape shape(step);
    for (int lane = 0; lane < count; lane += width) {
      const BatchJet a = load(shape, step.arguments[0], memory, lane);
      BatchJet b, c;
      if constexpr (arity > 1) b = load(shape, step.arguments[1], memory, lane);
      if constexpr (arity > 2) c = load(shape, step.arguments[2], memory, lane);
      store(shape, apply_rule<operation>(a, b, c, *step.constants), memory + step.result + lane);
    }
  }
  /// The same with all that it calls inlined: for compiled shapes.
  template <Operation operation, int arity>
  [[gnu::flatten]] static void apply_flattened(const Step& step, double* memory, int count) {
    apply<operation, arity>(step, memory, count);
  }

  // Reads and writes each coefficient where it is needed: twice as fast as whole jets.
  template <bool conjunction>
  static void r0_function(const Step& step, double* memory, int count) {
    const auto& [left, right, unused] = step.arguments;
    for (int lane = 0; lane < count; lane += width) {
      const auto reader = [&](const Register& from) {
        return [value = memory + from.value.offset() + lane * from.value.stride(),
                gradient = memory + from.gradient.offset() + lane * from.gradient.stride(),
                rest = memory + from.rest.offset() + lane * from.rest.stride()](int i) {
          const double* const place = i == 0   ? value
                                      : i <= N ? gradient + (i - 1) * block
                                               : rest + (i - 1 - N) * block;
          return Batch(place, std::experimental::element_aligned);
        };
      };
      double* const to = memory + step.result + lane;
      rfm::r0_function<conjunction, Batch, N, K>(
          reader(left), reader(right), [&](int i, const Batch& c) {
            c.copy_to(to + i * block, std::experimental::element_aligned);
          });
    }
  }

  template <class Rule>
  static void apply_to_one(const Step& step, double* memory, int count, const Rule& rule) {
    const Shape shape(step);
    for (int lane = 0; lane < count; lane += width)
      store(shape, rule(load(shape, step.arguments[0], memory, lane)), memory + step.result + lane);
  }

  static void scale(const Step& step, double* memory, int count) {
    apply_to_one(step, memory, count,
                 [&](const BatchJet& a) { return scaled(Batch(*step.constants), a); });
  }
  static void offset(const Step& step, double* memory, int count) {
    apply_to_one(step, memory, count, [&](BatchJet a) {
      a.c[0] += Batch(*step.constants);
      return a;
    });
  }

  // The argument has one order more; its coefficients shift down: (∂ᵢf)_α = (αᵢ + 1) f_{α+eᵢ}.
  static void partial(const Step& step, double* memory, int count) {
    const Shape shape(step);
    for (int i = 0; i < shape.size(); ++i) {
      const double factor = shape.exponent(i)[step.index] + 1.0;
      int index = shape.raised(step.index, i);
      const Part part = step.arguments[0].part_of(index, shape.variables());
      const double* const from = memory + part.offset() + index * block;
      double* const to = memory + step.result + i * block;
      for (int lane = 0; lane < count; ++lane) to[lane] = factor * from[lane * part.stride()];
    }
  }

  /// The kernel of an operation, if it is of this part (-1: of any).
  template <int part>
  static Kernel find(Operation operation) {
    switch (operation) {
      case Operation::scale:
        return scale;
      case Operation::offset:
        return offset;
      case Operation::partial:
        return partial;
#define RFM_KERNEL(id, name, arity, ...) \
  case Operation::id:                    \
    return kernel_of<Operation::id, arity, part>();
        RFM_OPERATIONS(RFM_KERNEL)
#undef RFM_KERNEL
      default:
        return nullptr;
    }
  }

 private:
  template <Operation operation, int arity, int part>
  static Kernel kernel_of() {
    constexpr bool is_fused = Shape::is_compiled && K <= 2;
    if constexpr (part >= 0 && static_cast<int>(operation) % kernel_parts != part)
      return nullptr;
    else if constexpr (is_fused && operation == Operation::r0_conjunction)
      return r0_function<true>;
    else if constexpr (is_fused && operation == Operation::r0_disjunction)
      return r0_function<false>;
    else if constexpr (Shape::is_compiled)
      return apply_flattened<operation, arity>;
    else
      return apply<operation, arity>;
  }
};

template <int N, int K, int part>
Kernel find_compiled_kernel(Operation operation) {
  return Kernels<N, K>::template find<part>(operation);
}

}  // namespace rfm
