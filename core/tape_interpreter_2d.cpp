#include "core/tape_interpreter.hpp"

namespace rfm {

template struct SinglePoint<2>;

}  // namespace rfm
