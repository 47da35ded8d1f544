#include "core/tape_interpreter.hpp"

namespace rfm {

template FunctionBounds SinglePoint<3>::bounds(const Tape::Program&, int, const Box&,
                                               const OtherRanges&);
template LineBounds SinglePoint<3>::bounds(const Tape::Program&, int, const Line&, const Interval&,
                                           const OtherRanges&);

}  // namespace rfm
