#pragma once

#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "problems/shape_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `relations`: `{intersect: [a, b]}`, `{inside: [a, b]}`, `{distance: [a, b], tolerance}`,
/// `{point: [x, y], in: a}`, a and b Boolean expressions of shapes.
std::vector<GeometricRelation> read_relations(const DocumentNode& root, ValueReader& values,
                                              ShapeReader& shapes);

struct RelationAnswer {
  const GeometricRelation* relation = nullptr;
  Truth truth = Truth::unknown;
  std::optional<Interval> distance;
  /// A witness; of distances the nearest points that were found; of what is undecided a point near
  /// the place.
  std::vector<Point> points;
};

/// Answers all of them. Shapes must have a bounding box (of two that intersect, and of inclusion
/// the first, one suffices) unless `bounds` is given. Throws `ProblemFileErrors` if they do not, or
/// if a distance is asked from an empty shape.
std::vector<RelationAnswer> answered(const std::vector<GeometricRelation>& relations,
                                     const std::optional<Box>& bounds);

/// "a and b intersect: yes, as at (0.5, 0)".
std::string relation_text(const RelationAnswer& answer, int dimension);
/// `truth` 1, 0 or null, `witness` or `near`; of distances `distance`, `at_least`, `from`, `to`.
nlohmann::ordered_json relations_json(const std::vector<RelationAnswer>& answers, int dimension);

}  // namespace rfm
