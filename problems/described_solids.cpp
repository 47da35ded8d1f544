#include "problems/described_solids.hpp"

#include <fmt/format.h>

#include "core/diagnosis.hpp"
#include "core/error.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

std::string list_or_none(const std::vector<std::string>& words) {
  return words.empty() ? "none" : fmt::format("{}", fmt::join(words, ", "));
}

}  // namespace

std::optional<DescribedSolid> read_described_solid(const DocumentNode& list, ValueReader& values,
                                                   SetReader& sets) {
  std::vector<ThinSet> pieces;
  std::vector<std::string> names;
  bool all_known = true;
  for (const DocumentNode& item : list.items) {
    const auto set = values.guarded<ThinSet>(item, [&] {
      if (!sets.contains(item.text))
        throw InputError("unknown set '" + item.text + "'" + did_you_mean(item.text, sets.names()),
                         0, item.text.size());
      return sets.built(item.text, 0);
    });
    all_known = all_known && set;
    if (!set) continue;
    for (std::size_t i = 0; i < set->parts.size(); ++i) {
      pieces.push_back(set->parts[i]);
      names.push_back(item.text + std::to_string(i + 1));
    }
    if (!set->parts.empty()) continue;
    pieces.push_back(*set);
    names.push_back(item.text);
  }
  if (!all_known) return std::nullopt;
  try {
    return described_solid(pieces, names);
  } catch (const InvalidArgument& mistake) {
    values.mistakes.add(mistake.what(), list.place);
    return std::nullopt;
  }
}

std::vector<std::string> description_lines(const std::string& shape, const DescribedSolid& solid) {
  if (!solid.conflict)
    return {fmt::format("shape {}: its pieces tell inside from outside, no separators", shape)};
  const int dimension = solid.region.dimension();
  return {fmt::format("shape {}: its pieces do not tell {}, inside, from {}, outside", shape,
                      point_text(solid.conflict->first, dimension),
                      point_text(solid.conflict->second, dimension)),
          fmt::format("  separators: {}; tried and not needed: {}", list_or_none(solid.separators),
                      list_or_none(solid.needless))};
}

}  // namespace rfm
