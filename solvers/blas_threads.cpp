#include "solvers/blas_threads.hpp"

#include <mutex>

// Present when the BLAS is OpenBLAS and when CHOLMOD uses OpenMP, whose threads spin between the
// tiny loops of a factorisation and cost a third of its time.
extern "C" void openblas_set_num_threads(int count) __attribute__((weak));
extern "C" int blas_thread_shutdown_() __attribute__((weak));
extern "C" void omp_set_max_active_levels(int levels) __attribute__((weak));

namespace rfm {

void use_one_thread_in_blas() {
  static std::once_flag once;
  std::call_once(once, [] {
    if (openblas_set_num_threads != nullptr) openblas_set_num_threads(1);
    if (blas_thread_shutdown_ != nullptr) blas_thread_shutdown_();
  });
  // This one is a setting of each thread.
  if (omp_set_max_active_levels != nullptr) omp_set_max_active_levels(0);
}

}  // namespace rfm
