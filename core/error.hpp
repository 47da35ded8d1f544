#pragma once

#include <stdexcept>
#include <string>

namespace rfm {

/// Base of everything this library throws on purpose.
///
///     Error ← InvalidArgument     a caller's mistake: an order that does not exist, an empty list
///           ← InputError          a user's text is wrong; carries its place; exit status 2
///           ← ComputationError    the input is right but the computation failed; exit status 3
///
/// A recoverable loss of accuracy is never an exception: it is data in a report.
struct Error : std::runtime_error {
  using std::runtime_error::runtime_error;
};

struct InvalidArgument : Error {
  using Error::Error;
};

struct ComputationError : Error {
  using Error::Error;
};

/// A mistake in a text. `offset` is the 0-based byte offset in that text where the mistake begins,
/// `length` how many bytes it spans (at least 1, for a caret); whoever knows the file turns it into
/// file:line:column.
struct InputError : Error {
  InputError(const std::string& message, std::size_t offset, std::size_t length = 1)
      : Error(message), offset(offset), length(length) {}
  std::size_t offset;
  std::size_t length;
};

}  // namespace rfm
