#include "core/tape_interpreter.hpp"

namespace rfm {

template void SinglePoint<3>::jet(const Tape::Program&, int, const Point&, const OtherValues&,
                                  std::span<double>);
template Interval SinglePoint<3>::value_bounds(const Tape::Program&, int, const Box&,
                                               const OtherRanges&);

}  // namespace rfm
