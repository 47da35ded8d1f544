#pragma once

#include <optional>
#include <string>

#include "core/outline.hpp"
#include "problems/point_files.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads shapes that are given by lists of points, in the file or in files of their own beside it:
/// polygons, curved polygons, polylines and splines.
class OutlineReader {
 public:
  /// Refers to `values`.
  explicit OutlineReader(const ValueReader& values) : values_(values) {}

  static bool reads(const std::string& kind);
  /// The shape of this kind; nothing if it has a mistake, which is reported.
  std::optional<Outline> read(const std::string& kind, const DocumentNode& node) const;

 private:
  std::optional<Outline> read_polygon(const std::string& kind, const DocumentNode& node) const;
  std::optional<Outline> read_stroke(const std::string& kind, const DocumentNode& node) const;
  bool is_closed_outline(const std::string& kind, const std::vector<PointList>& lists,
                         const DocumentNode& file) const;
  bool has_straight_edges(const std::string& kind, const std::vector<PointList>& lists,
                          const DocumentNode& file) const;

  const ValueReader& values_;
};

}  // namespace rfm
