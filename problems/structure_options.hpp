#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/thin_set.hpp"
#include "problems/problem.hpp"

namespace rfm {

/// A value that an unknown takes on a set which need not bound anything: `{at: wire, value: ..}`.
struct SetValue {
  std::string set;
  int component = 0;  ///< the unknown, by its number
  ThinSet where;
  Field value;
  Place place;
};

/// `{at: shape, interface: {jump: ..}}`: across the boundary of a shape inside the domain u jumps
/// by `jump` (its value inside the shape less that outside), and its slope is free to jump.
struct InterfaceCondition {
  std::string shape;
  Region region;
  Field omega;
  Field jump;
  Place place;
};

/// `enrich`: singular functions at a point of the boundary in the plane.
struct Enrichment {
  Point at{};
  std::vector<double> exponents;  ///< empty: from the angle and the conditions
  Place place;
};

/// `windows`: more freedom for u within a shape, by splines on a grid of their own.
struct WindowOption {
  std::string shape;
  Region region;
  std::optional<int> degree;  ///< nothing: that of the domain
  int cells = 0;              ///< along the longest side of the shape's part of the domain
  int smoothness = 0;         ///< m: so many derivatives are continuous across the edge
  bool global = true;         ///< solved together with all else
  Place place;
};

/// What a file says of its structure beside the conditions on the boundary.
struct StructureOptions {
  std::vector<SetValue> values;
  std::vector<InterfaceCondition> interfaces;
  std::vector<Enrichment> enrichments;
  std::vector<WindowOption> windows;

  bool is_empty() const {
    return values.empty() && interfaces.empty() && enrichments.empty() && windows.empty();
  }
};

/// Whether an entry of `conditions` is about the inside of the domain and not its boundary: an
/// interface, or a set.
bool is_inner_condition(const DocumentNode& condition, const std::vector<std::string>& sets);

/// Read from the document of a problem whose boundary conditions, shapes and sets were read. Throws
/// `ProblemFileErrors`.
StructureOptions structure_options(const Problem& problem);

}  // namespace rfm
