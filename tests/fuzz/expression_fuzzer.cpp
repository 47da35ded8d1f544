// Any text is a formula, an expression of shapes, or an `InputError` whose place lies in the text.
#include <cstdint>
#include <cstdlib>

#include "core/boolean_text.hpp"
#include "core/error.hpp"
#include "core/expression.hpp"
#include "core/primitives.hpp"

namespace {

rfm::ExpressionScope scope() {
  rfm::ExpressionScope scope = rfm::coordinate_scope(2);
  rfm::define_derivatives(scope, 2);
  scope.define("a", 2.0);
  scope.define("v", rfm::ExpressionValue(rfm::gradient(rfm::x_coordinate(), 2)));
  scope.define("square", rfm::Expression("x^2 + y^2"));
  scope.define_function("f", {"p", "q"}, rfm::Expression("p - 2*q"));
  return scope;
}

template <class Action>
void require_place_in(const std::string& text, const Action& action) {
  try {
    action();
  } catch (const rfm::InputError& mistake) {
    if (mistake.offset > text.size() || mistake.length == 0) std::abort();
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  static const rfm::ExpressionScope known = scope();
  const std::string text(reinterpret_cast<const char*>(data), size);
  require_place_in(text, [&] { rfm::evaluate(rfm::Expression(text), known); });
  require_place_in(text, [&] {
    rfm::BooleanText(text).region([](const rfm::BooleanText::Name& name) {
      return rfm::level_set(rfm::x_coordinate()).named(name.name);
    });
  });
  return 0;
}
