#include "problems/other_problems.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>

#include "core/error.hpp"
#include "problems/reader.hpp"
#include "problems/restricted_field.hpp"
#include "problems/scalar_problem.hpp"
#include "problems/text_files.hpp"

namespace rfm {
namespace {

[[noreturn]] void refuse(const std::string& message, const Place& place) {
  throw ProblemFileErrors({Mistake{message, place}});
}

std::string same_name(const std::string& path) {
  return std::filesystem::weakly_canonical(path).string();
}

}  // namespace

struct OtherProblems::Solved {
  Problem problem;
  ExpressionScope scope;
  Box box;
};

OtherProblems::OtherProblems(std::vector<std::string> files, int dimension)
    : files_(std::move(files)), dimension_(dimension) {}

OtherProblems::~OtherProblems() = default;

const OtherProblems::Solved& OtherProblems::solved(const DocumentNode& from) {
  const std::string folder = std::filesystem::path(files_.back()).parent_path().string();
  try {
    read_text_beside(folder, from.text, "another problem");
  } catch (const InputError& error) {
    refuse(error.what(), from.place);
  }
  const std::string path = (std::filesystem::path(folder) / from.text).string();
  const auto known = solved_.find(same_name(path));
  if (known != solved_.end()) return *known->second;
  const auto open = std::ranges::find(files_, same_name(path), same_name);
  if (open != files_.end()) {
    std::string cycle;
    for (auto file = open; file != files_.end(); ++file)
      cycle += std::filesystem::path(*file).filename().string() + " -> ";
    refuse("a problem that needs its own solution: " + cycle +
               std::filesystem::path(path).filename().string(),
           from.place);
  }
  std::vector<std::string> files = files_;
  files.push_back(path);
  auto solved = std::make_unique<Solved>();
  solved->problem = read_problem(path, {}, files);
  if (solved->problem.dimension != dimension_)
    refuse(fmt::format("that problem has dimension {}, this one {}", solved->problem.dimension,
                       dimension_),
           from.place);
  try {
    const ScalarProblem scalar(solved->problem);
    const ScalarSolution solution = scalar.solve(scalar.grid());
    solved->scope = solved->problem.scope;
    define_results(solved->scope, solution.results);
    refuse_normal(
        solved->scope, dimension_,
        "is known on the boundary of that problem only: expected a field inside, as flux.x");
    solved->box = scalar.bounds();
  } catch (const ComputationError& error) {
    throw ComputationError(from.text + ": " + error.what());
  }
  return *(solved_[same_name(path)] = std::move(solved));
}

Field OtherProblems::result(const DocumentNode& map) {
  const DocumentNode* from = map.find("from");
  const DocumentNode* name = map.find("field");
  if (!from || !name) refuse("expected {from: other.yaml, field: u}", map.place);
  const Solved& other = solved(*from);
  try {
    const Field result = to_field(Expression(name->text), other.scope);
    return field(std::make_shared<RestrictedField>(
        result, *other.problem.domain, other.box,
        fmt::format("the field '{}' of {} ({})", name->text, from->text, name->place.text())));
  } catch (const InputError& error) {
    refuse(fmt::format("in {}: {}", from->text, error.what()),
           name->place_within(error.offset, error.length));
  }
}

}  // namespace rfm
