// Any text is a problem or `ProblemFileErrors`; a problem written as resolved is read again.
#include <cstdint>
#include <cstdlib>

#include "problems/reader.hpp"
#include "problems/resolved_document.hpp"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string text(reinterpret_cast<const char*>(data), size);
  std::string resolved;
  try {
    resolved = rfm::document_text(rfm::read_problem(rfm::make_source("f.yaml", text)).document);
  } catch (const rfm::ProblemFileErrors&) {
    return 0;
  }
  const rfm::Problem again = rfm::read_problem(rfm::make_source("resolved.yaml", resolved));
  if (rfm::document_text(again.document) != resolved) std::abort();
  return 0;
}
