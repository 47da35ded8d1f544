// Compiled without contraction (core/CMakeLists.txt): see tape_polynomial.hpp.
#include "core/scalar.hpp"
#include "core/tape_polynomial.hpp"

namespace rfm {
namespace {

constexpr int block = Tape::block_size;
constexpr int width = static_cast<int>(Batch::size());

Batch load(const double* from) { return Batch(from, std::experimental::element_aligned); }
void store(const Batch& batch, double* to) {
  batch.copy_to(to, std::experimental::element_aligned);
}

template <int terms>
void affine(const Step& step, double* memory, int count) {
  const double* const c = step.constants;
  const Batch scale = c[0], first = c[1], last = c[2];
  for (int lane = 0; lane < count; lane += width) {
    Batch sum = first;
    for (int k = 0; k < terms; ++k) {
      const Batch x = load(memory + step.arguments[k].value.offset() + lane);
      sum += c[3 + 2 * k] * (x - c[4 + 2 * k]);
    }
    store((sum + last) * scale, memory + step.result + lane);
  }
}

template <int N, bool with_gradient>
void quadratic_sum(const Step& step, double* memory, int count) {
  const double* const c = step.constants;
  const Batch scale = c[0], first = c[1], last = c[2];
  double* slope[N];
  for (int k = 0; k < N; ++k)
    slope[k] = memory + step.result + (1 + (step.index >> (2 * k) & 3)) * block;
  for (int lane = 0; lane < count; lane += width) {
    Batch sum = first;
    for (int k = 0; k < N; ++k) {
      const Batch t = load(memory + step.arguments[k].value.offset() + lane) - c[3 + 3 * k];
      const Batch linear = c[4 + 3 * k], quadratic = c[5 + 3 * k];
      // One of the factors is 0; t² may overflow where it is not asked for.
      sum += (linear + quadratic) * (t * select(quadratic == 0, Batch(1.0), t));
      if constexpr (with_gradient)
        store(scale * (linear + (quadratic + quadratic) * t), slope[k] + lane);
    }
    store((sum + last) * scale, memory + step.result + lane);
  }
}

template <int N>
void quadric_gradient(const Step& step, double* memory, int count) {
  const double* const origin = step.constants;
  for (int lane = 0; lane < count; lane += width) {
    Batch t[N];
    for (int j = 0; j < N; ++j)
      t[j] = load(memory + step.arguments[j].value.offset() + lane) - origin[j];
    for (int i = 0; i < N; ++i) {
      const double* const row = origin + N + i * (N + 1);
      Batch slope = row[0];
      for (int j = 0; j < N; ++j) slope += row[1 + j] * t[j];
      store(slope, memory + step.result + i * block + lane);
    }
  }
}

}  // namespace

Kernel affine_kernel(int terms) {
  constexpr Kernel kernels[] = {affine<0>, affine<1>, affine<2>, affine<3>};
  return kernels[terms];
}

Kernel quadratic_sum_kernel(int dimension, bool with_gradient) {
  constexpr Kernel kernels[3][2] = {{quadratic_sum<1, false>, quadratic_sum<1, true>},
                                    {quadratic_sum<2, false>, quadratic_sum<2, true>},
                                    {quadratic_sum<3, false>, quadratic_sum<3, true>}};
  return kernels[dimension - 1][with_gradient];
}

Kernel quadric_gradient_kernel(int dimension) {
  constexpr Kernel kernels[] = {quadric_gradient<1>, quadric_gradient<2>, quadric_gradient<3>};
  return kernels[dimension - 1];
}

}  // namespace rfm
