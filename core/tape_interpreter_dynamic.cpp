#include "core/tape_interpreter.hpp"

namespace rfm {

template struct SinglePoint<run_time>;

}  // namespace rfm
