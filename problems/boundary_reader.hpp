#pragma once

#include "problems/problem.hpp"
#include "problems/shape_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `regions` and `conditions`, and knows what may name a part of the boundary.
class BoundaryReader {
 public:
  BoundaryReader(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                 Problem& problem)
      : root_(root), values_(values), shapes_(shapes), problem_(problem) {}

  void read_regions();
  void read_conditions();
  /// The part of the boundary that a name stands for. Throws `InputError` for a name that stands
  /// for none, with a suggestion.
  BoundaryTarget target(const std::string& name, const Place& place);
  bool is_region(const std::string& name) const { return problem_.regions.contains(name); }
  /// Regions that nothing names are mistakes; in a document with other mistakes only those that no
  /// text of it names.
  void report_unused();

  /// The parts that a name, or a list of names, stands for; what stands for none is a mistake.
  std::vector<BoundaryTarget> targets(const DocumentNode& node);

 private:
  std::vector<std::string> pieces_of(const std::string& name);
  void read_region(const DocumentNode::Entry& entry);
  void read_parts(const DocumentNode& of, const DocumentNode& map, BoundaryTarget& region);
  void mark_shapes(const DocumentNode& condition);
  void read_condition(const DocumentNode& node);

  const DocumentNode& root_;
  ValueReader& values_;
  ShapeReader& shapes_;
  Problem& problem_;
  std::set<std::string> pieces_;  ///< primitives of the domain
  std::set<std::string> used_regions_;
};

}  // namespace rfm
