#pragma once

#include "core/operation_rules.hpp"
#include "core/tape_program.hpp"

namespace rfm {

/// Kernels for N variables and order K, instantiated in tape_kernels_{1,2,3}d.cpp: load the jets of
/// a few points, apply the rule, store, for all points of the block.
template <int N, int K>
struct Kernels {
  using BatchJet = Jet<Batch, N, K>;
  static constexpr int width = static_cast<int>(Batch::size());
  static constexpr int block = Tape::block_size;

  static BatchJet load(const Register& from, const double* memory, int lane) {
    BatchJet jet;
    const auto read = [&](int first, int last, const Part& part) {
      const double* const place = memory + part.offset() + lane * part.stride();
      for (int i = first; i < last; ++i)
        jet.c[i].copy_from(place + (i - first) * block, std::experimental::element_aligned);
    };
    read(0, 1, from.value);
    if constexpr (K >= 1) read(1, 1 + N, from.gradient);
    if constexpr (K >= 2) read(1 + N, jet.size, from.rest);
    return jet;
  }
  static void store(const BatchJet& jet, double* to) {
    for (int i = 0; i < jet.size; ++i)
      jet.c[i].copy_to(to + i * block, std::experimental::element_aligned);
  }

  template <Operation operation, int arity>
  [[gnu::flatten]] static void apply(const Step& step, double* memory, int count) {
    for (int lane = 0; lane < count; lane += width) {
      const BatchJet a = load(step.arguments[0], memory, lane);
      BatchJet b, c;
      if constexpr (arity > 1) b = load(step.arguments[1], memory, lane);
      if constexpr (arity > 2) c = load(step.arguments[2], memory, lane);
      store(apply_rule<operation>(a, b, c, *step.constants), memory + step.result + lane);
    }
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
    for (int lane = 0; lane < count; lane += width)
      store(rule(load(step.arguments[0], memory, lane)), memory + step.result + lane);
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
    for (int i = 0; i < BatchJet::size; ++i) {
      const MultiIndex& alpha = JetTables<N, K>::exponents[i];
      const double factor = alpha[step.index] + 1.0;
      int index = jet_index(N, alpha + unit_index(step.index));
      const Part part = step.arguments[0].part_of(index, N);
      const double* const from = memory + part.offset() + index * block;
      double* const to = memory + step.result + i * block;
      for (int lane = 0; lane < count; ++lane) to[lane] = factor * from[lane * part.stride()];
    }
  }

  static Kernel find(Operation operation) {
    if constexpr (K <= 2) {
      if (operation == Operation::r0_conjunction) return r0_function<true>;
      if (operation == Operation::r0_disjunction) return r0_function<false>;
    }
    switch (operation) {
      case Operation::scale:
        return scale;
      case Operation::offset:
        return offset;
      case Operation::partial:
        return partial;
#define RFM_KERNEL(id, name, arity, ...) \
  case Operation::id:                    \
    return apply<Operation::id, arity>;
        RFM_OPERATIONS(RFM_KERNEL)
#undef RFM_KERNEL
      default:
        return nullptr;
    }
  }
};

}  // namespace rfm
