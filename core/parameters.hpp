#pragma once

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/field.hpp"

namespace rfm {

/// Numbers with names that fields depend on, and that change without anything being compiled again:
///
///     Parameters parameters{{"r", 0.25}};
///     const Field r = parameters["r"];                            // a field, written as `r`
///     const Tape tape({r * r - x * x - y * y}, {1}, 2);
///     tape.value({0.3, 0}, 0, {0, parameters});                   // −0.0275
///     parameters.set("r", 0.5);
///     tape.value({0.3, 0}, 0, {0, parameters});                   // 0.16
///     derivative_with_respect_to(circle, r);                      // again a field: 2 r
///
/// Parameters are numbered in the order in which they were added; whatever takes the values of
/// parameters takes them in this order, and a `Parameters` itself. Fields of one tape must not
/// belong to two sets which give one number two names: this is refused when it is compiled.
class Parameters {
 public:
  Parameters() = default;
  Parameters(std::initializer_list<std::pair<std::string, double>> named);

  /// A further parameter, as a field. Throws `InvalidArgument` if the name is taken, no name
  /// (a letter, then letters, digits and `_`), or has a meaning in formulas (`x`, `pi`, `sin`).
  Field add(const std::string& name, double value);
  /// The parameter of this name as a field, its value, a new value. Throw `InvalidArgument` where
  /// there is none, with the nearest name.
  Field operator[](std::string_view name) const;
  double value(std::string_view name) const;
  void set(std::string_view name, double value);
  bool contains(std::string_view name) const;

  std::size_t size() const { return values_.size(); }
  const std::vector<std::string>& names() const { return names_; }
  std::span<const double> values() const { return values_; }
  operator std::span<const double>() const { return values_; }  // NOLINT: it is the values

 private:
  std::size_t place_of(std::string_view name) const;

  std::vector<std::string> names_;
  std::vector<Field> fields_;
  std::vector<double> values_;
};

/// `f` with the present values of `parameters` as constants, which fold; parameters beyond the set
/// stay. For what is worth compiling again: constants are cheaper, and polynomials are recognised.
Field with_values(const Field& f, const Parameters& parameters);

}  // namespace rfm
