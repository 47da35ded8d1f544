#pragma once

#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "core/field_source.hpp"
#include "core/named_source.hpp"
#include "core/region.hpp"
#include "core/tape.hpp"

namespace rfm {

/// A field that exists in a region only, as the solution of a problem does: it is not a number at
/// points outside, farther from it than rounding. What was continued beyond the boundary by a
/// formula would be a number like any other, and wrong.
class RestrictedField final : public FieldSource, public NamedSource {
 public:
  /// `box` holds the region; `name` is what messages call the field.
  RestrictedField(Field field, const Region& region, const Box& box, std::string name);

  /// In as many variables as the region has dimensions, or more.
  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// Those of the formula, for the part of the box where the field exists.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override { return box_; }
  std::string outside_text() const override;

 private:
  const Tape& tape(int variables, int order) const;

  Field field_;
  RegionEvaluator region_;
  Box box_;
  std::string name_;
  mutable std::mutex mutex_;
  mutable std::map<std::pair<int, int>, std::unique_ptr<const Tape>> tapes_;
};

}  // namespace rfm
