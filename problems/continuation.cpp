#include "problems/continuation.hpp"

#include "problems/reader.hpp"
#include "problems/resolved_document.hpp"

namespace rfm {
std::vector<ContinuationStop> continuation_stops(const Problem& problem) {
  std::vector<ContinuationStop> stops;
  if (!problem.discretization.continuation) return stops;
  const auto& [parameter, values] = *problem.discretization.continuation;
  // Parameters are constants in what was read: the file is read again, as it was with its
  // overrides.
  const auto source = make_source(problem.file, document_text(problem.document));
  for (const std::string& value : values)
    stops.push_back({parameter + " = " + value,
                     read_problem(source, {"parameters." + parameter + "=" + value})});
  return stops;
}

}  // namespace rfm
