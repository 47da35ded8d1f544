#pragma once

namespace rfm {

/// BLAS runs on the thread that calls it from now on, and threads that OpenBLAS started when the
/// program was loaded are ended: waiting for work they would spin for some 25 ms, as long as a
/// small problem takes. Threads inside BLAS gain nothing on the small blocks of spline matrices,
/// and results would depend on their number. Called by `SymmetricFactorization`; call it first
/// thing in `main` to save those milliseconds. No other thread may be inside BLAS at the first
/// call.
void use_one_thread_in_blas();

}  // namespace rfm
