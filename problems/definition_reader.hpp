#pragma once

#include <map>
#include <memory>

#include "problems/problem.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// Reads `parameters`, `fields` and `functions` into a problem and into the scopes of `values`.
class DefinitionReader {
 public:
  /// All must outlive the reader.
  DefinitionReader(const DocumentNode& root, ValueReader& values, Problem& problem);
  ~DefinitionReader();

  /// `values.scope` must already hold what every formula may name, except `omega`. Parameters may
  /// use each other in any order; definitions that use themselves, however indirectly, are mistakes
  /// that name the cycle.
  void read();
  /// Checks every field and function as a formula, with stand-ins for what is known only later. To
  /// be called when `omega(name)` has a meaning, before anything uses a definition.
  void check();

 private:
  class Definitions;
  std::unique_ptr<Definitions> definitions_;
};

}  // namespace rfm
