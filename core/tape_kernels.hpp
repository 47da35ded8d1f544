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

  static BatchJet load(const double* memory, int row, int lane) {
    BatchJet jet;
    for (int i = 0; i < jet.size; ++i)
      jet.c[i].copy_from(memory + (row + i) * block + lane, std::experimental::element_aligned);
    return jet;
  }
  static void store(const BatchJet& jet, double* memory, int row, int lane) {
    for (int i = 0; i < jet.size; ++i)
      jet.c[i].copy_to(memory + (row + i) * block + lane, std::experimental::element_aligned);
  }

  template <Operation operation, int arity>
  static void apply(const Instruction& instruction, double* memory, int count) {
    const auto& rows = instruction.operand_rows;
    for (int lane = 0; lane < count; lane += width) {
      const BatchJet a = load(memory, rows[0], lane);
      BatchJet b, c;
      if constexpr (arity > 1) b = load(memory, rows[1], lane);
      if constexpr (arity > 2) c = load(memory, rows[2], lane);
      store(apply_rule<operation>(a, b, c), memory, instruction.result_row, lane);
    }
  }

  template <class Rule>
  static void apply_to_one(const Instruction& instruction, double* memory, int count,
                           const Rule& rule) {
    for (int lane = 0; lane < count; lane += width)
      store(rule(load(memory, instruction.operand_rows[0], lane)), memory, instruction.result_row,
            lane);
  }

  static void integer_power(const Instruction& instruction, double* memory, int count) {
    apply_to_one(instruction, memory, count,
                 [&](const BatchJet& a) { return rfm::integer_power(a, instruction.index); });
  }
  static void real_power(const Instruction& instruction, double* memory, int count) {
    apply_to_one(instruction, memory, count,
                 [&](const BatchJet& a) { return rfm::real_power(a, instruction.number); });
  }
  static void scale(const Instruction& instruction, double* memory, int count) {
    apply_to_one(instruction, memory, count,
                 [&](const BatchJet& a) { return scaled(Batch(instruction.number), a); });
  }
  static void offset(const Instruction& instruction, double* memory, int count) {
    apply_to_one(instruction, memory, count, [&](BatchJet a) {
      a.c[0] += Batch(instruction.number);
      return a;
    });
  }

  // The argument has one order more; its coefficients shift down: (∂ᵢf)_α = (αᵢ + 1) f_{α+eᵢ}.
  static void partial(const Instruction& instruction, double* memory, int count) {
    for (int i = 0; i < BatchJet::size; ++i) {
      const MultiIndex& alpha = JetTables<N, K>::exponents[i];
      const double factor = alpha[instruction.index] + 1.0;
      const int row =
          instruction.operand_rows[0] + jet_index(N, alpha + unit_index(instruction.index));
      const double* from = memory + row * block;
      double* to = memory + (instruction.result_row + i) * block;
      for (int lane = 0; lane < count; ++lane) to[lane] = factor * from[lane];
    }
  }

  static Kernel find(Operation operation) {
    switch (operation) {
      case Operation::integer_power:
        return integer_power;
      case Operation::real_power:
        return real_power;
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
