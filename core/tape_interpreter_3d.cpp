#include "core/tape_interpreter.hpp"

namespace rfm {

template struct SinglePoint<3>;

}  // namespace rfm
