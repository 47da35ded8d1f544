#include "problems/reader.hpp"

#include <filesystem>

#include "core/r_system_functions.hpp"
#include "problems/boundary_coverage.hpp"
#include "problems/boundary_reader.hpp"
#include "problems/combine_reader.hpp"
#include "problems/custom_physics.hpp"
#include "problems/definition_reader.hpp"
#include "problems/geometric_relations.hpp"
#include "problems/lifted_results.hpp"
#include "problems/other_problems.hpp"
#include "problems/overrides.hpp"
#include "problems/physics_reader.hpp"
#include "problems/result_scope.hpp"
#include "problems/run_reader.hpp"
#include "problems/schema_check.hpp"
#include "problems/shape_reader.hpp"
#include "problems/table_reader.hpp"

namespace rfm {
namespace {

void define_common_names(ValueReader& values, const std::string& folder) {
  const int dimension = values.dimension;
  values.scope = coordinate_scope(dimension);
  define_derivatives(values.scope, dimension);
  constexpr int of_structures_and_forms = 4;  // what these take besides
  values.scope.limit_derivatives(maximum_order - of_structures_and_forms);
  define_r_functions(values.scope);
  const ExpressionFunction table = table_function(folder);
  values.scope.define_function("table", table);
  values.number_scope.define_function("table", table);
  refuse_normal(values.scope, dimension, "is known on a boundary only");
  refuse_results(
      values.scope, values.results,
      "is a result: only coefficients of the equation and natural conditions may contain it");
  for (const char* name : {"x", "y", "z", "t"})
    values.number_scope.refuse(name, "is a coordinate: a number is needed here");
  refuse_normal(values.number_scope, dimension, "is a normal: a number is needed here");
  refuse_results(values.number_scope, values.results, "is a result: a number is needed here");
}

void read_geometry(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                   Problem& problem) {
  shapes.read_all();
  problem.shapes = shapes.shapes();
  problem.domain = shapes.domain();
  problem.described = shapes.described();
  const DocumentNode* geometry = values.find(root, "geometry");
  if (!geometry) return;
  if (const DocumentNode* bounds = values.find(*geometry, "bounds"))
    problem.bounds = values.box(*bounds);
  if (const DocumentNode* combine = values.find(*geometry, "combine"))
    problem.combine = read_combine(*combine, values, problem.domain);
}

void read_contents(ValueReader& values, Problem& problem) {
  const DocumentNode& root = problem.document;
  if (const DocumentNode* version = values.find(root, "rfm")) values.integer(*version);
  if (const DocumentNode* title = values.find(root, "title")) problem.title = title->text;
  problem.physics.unknowns = unknown_names(root, values);
  const DocumentNode* physics = values.find(root, "physics");
  const DocumentNode* type = physics ? values.find(*physics, "type") : nullptr;
  const bool has_flux = !type || (type->text != "custom" && type->text != "interpolation");
  values.results = stand_in_results(problem.physics.unknowns, has_flux, problem.dimension);
  define_common_names(values, std::filesystem::path(problem.file).parent_path().string());
  DefinitionReader definitions(root, values, problem);
  definitions.read();
  problem.study = read_study(root, values);
  if (problem.study.type == Study::Type::eigen)
    values.results = stand_in_results(problem.physics.unknowns, has_flux, problem.dimension,
                                      problem.study.count);
  SetReader sets(root, values);
  ShapeReader shapes(root, values, sets);
  definitions.check();
  read_geometry(root, values, shapes, problem);
  sets.read_all();
  problem.sets = sets.sets();
  problem.relations = read_relations(root, values, shapes);
  read_physics(root, values, shapes, problem);
  BoundaryReader boundary(root, values, shapes, problem);
  boundary.read_regions();
  boundary.read_conditions();
  read_custom_boundary(root, values, boundary, problem);
  problem.discretization = read_discretization(root, values, problem.physics.unknowns);
  read_probes(root, values, shapes, boundary, problem);
  read_verification(root, values, problem);
  read_outputs(root, values, problem);

  shapes.report_unused();
  boundary.report_unused();
  if (problem.domain) check_overlaps(problem, values.mistakes);
}

}  // namespace

Problem read_problem(std::shared_ptr<const SourceText> source,
                     const std::vector<std::string>& overrides,
                     const std::vector<std::string>& files) {
  Problem problem;
  problem.file = source->name;
  problem.document = parse_document(source);
  MistakeList mistakes;
  apply_overrides(problem.document, overrides, mistakes);
  lift_results(problem.document);
  const SchemaMatch match = check_structure(problem.document, mistakes);
  ValueReader values(match, mistakes);
  if (const DocumentNode* dimension = values.find(problem.document, "dimension"))
    problem.dimension = dimension->text[0] - '0';
  values.dimension = problem.dimension;
  OtherProblems others(files.empty() ? std::vector{problem.file} : files, problem.dimension);
  values.result_of_other_problem = [&](const DocumentNode& map) { return others.result(map); };
  // A dimension that is wrong makes everything else look wrong.
  if (values.find(problem.document, "dimension")) read_contents(values, problem);
  mistakes.throw_if_any();
  problem.scope = std::move(values.scope);
  return problem;
}

Problem read_problem(const std::string& path, const std::vector<std::string>& overrides,
                     const std::vector<std::string>& files) {
  return read_problem(read_source(path), overrides, files);
}

}  // namespace rfm
