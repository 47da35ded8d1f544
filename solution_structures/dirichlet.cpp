#include "solution_structures/dirichlet.hpp"

namespace rfm {

Structure dirichlet(const Field& g, const Field& omega) {
  return g + omega * Structure::undetermined();
}

}  // namespace rfm
