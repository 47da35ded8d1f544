#include "problems/continuation.hpp"

#include "problems/reader.hpp"
#include "problems/resolved_document.hpp"

namespace rfm {
namespace {

const DocumentNode* find(const DocumentNode& root, std::initializer_list<const char*> path) {
  const DocumentNode* node = &root;
  for (const char* key : path) node = node ? node->find(key) : nullptr;
  return node;
}

}  // namespace

std::vector<ContinuationStop> continuation_stops(const Problem& problem) {
  std::vector<ContinuationStop> stops;
  const DocumentNode* path = find(problem.document, {"discretization", "solver", "continuation"});
  if (!path) return stops;
  const std::string parameter = path->find("parameter")->text;
  // Parameters are constants in what was read: the file is read again, as it was with its
  // overrides.
  const auto source = make_source(problem.file, document_text(problem.document));
  for (const DocumentNode& value : path->find("values")->items)
    stops.push_back({parameter + " = " + value.text,
                     read_problem(source, {"parameters." + parameter + "=" + value.text})});
  return stops;
}

}  // namespace rfm
