#include "core/tape_interpreter.hpp"

namespace rfm {

template void SinglePoint<2>::jet(const Tape::Program&, int, const Point&, const OtherValues&,
                                  std::span<double>);
template Interval SinglePoint<2>::value_bounds(const Tape::Program&, int, const Box&,
                                               const OtherRanges&);

}  // namespace rfm
