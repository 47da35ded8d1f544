#include "core/r_equivalence.hpp"

#include "core/error.hpp"

namespace rfm {

Field equivalence(const Field& x, const Field& y, int p) {
  return apply(Operation::rp_equivalence, {x, y}, p);
}

Field equivalence(const std::vector<Field>& fields, int p) {
  if (fields.empty()) throw InvalidArgument("the R-equivalence of no fields does not exist");
  // In pairs of pairs: as deep as the logarithm of their number, and as exact.
  std::vector<Field> level = fields;
  while (level.size() > 1) {
    std::vector<Field> next;
    for (std::size_t i = 0; i + 1 < level.size(); i += 2)
      next.push_back(equivalence(level[i], level[i + 1], p));
    if (level.size() % 2 == 1) next.push_back(level.back());
    level = std::move(next);
  }
  return level[0];
}

}  // namespace rfm
