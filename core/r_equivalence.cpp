#include "core/r_equivalence.hpp"

#include "core/error.hpp"

namespace rfm {

Field equivalence(const Field& x, const Field& y, int p) {
  return apply(Operation::rp_equivalence, {x, y}, p);
}

Field equivalence(const std::vector<Field>& fields, int p) {
  if (fields.empty()) throw InvalidArgument("the R-equivalence of no fields does not exist");
  Field joined = fields[0];
  for (std::size_t i = 1; i < fields.size(); ++i) joined = equivalence(joined, fields[i], p);
  return joined;
}

}  // namespace rfm
