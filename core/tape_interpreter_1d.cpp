#include "core/tape_interpreter.hpp"

namespace rfm {

template struct SinglePoint<1>;

}  // namespace rfm
