#pragma once

#include <string>

namespace rfm {

/// Of a `FieldSource` that can say what it is, to whoever asks it for values it does not have.
class NamedSource {
 public:
  virtual ~NamedSource() = default;
  /// "the field 'u' of plate.yaml (beam.yaml:7:20) outside the domain of that problem".
  virtual std::string outside_text() const = 0;
};

}  // namespace rfm
