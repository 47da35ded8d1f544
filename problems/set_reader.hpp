#pragma once

#include <map>
#include <string>

#include "core/thin_set.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `sets`: points, curves and surfaces that need not be boundaries. A set is built when it is
/// first named, since formulas of curves may name other sets and shapes.
class SetReader {
 public:
  /// Both must outlive the reader.
  SetReader(const DocumentNode& root, ValueReader& values);

  /// Builds what has not been named yet.
  void read_all();
  bool contains(const std::string& name) const { return nodes_.contains(name); }
  std::vector<std::string> names() const;
  /// The set of this name, which is one. Throws `InputError` at `offset` if it contains itself.
  const ThinSet& built(const std::string& name, std::size_t offset);
  /// Sets that were built; those with mistakes are stand-ins.
  const std::map<std::string, ThinSet>& sets() const { return built_; }

 private:
  ThinSet build(const DocumentNode& node);
  ThinSet segment(const DocumentNode& map);
  ThinSet arc(const DocumentNode& map);
  ThinSet curve(const DocumentNode& map);
  ThinSet triangle(const DocumentNode& list);
  ThinSet polyline(const DocumentNode& map);
  ThinSet mesh(const DocumentNode& file);

  ValueReader& values_;
  std::map<std::string, const DocumentNode*> nodes_;
  std::map<std::string, Place> key_places_;
  std::map<std::string, ThinSet> built_;
  std::vector<std::string> building_;
};

}  // namespace rfm
