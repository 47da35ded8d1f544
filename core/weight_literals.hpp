#pragma once

#include <string>

#include "core/combine_rule.hpp"
#include "core/region.hpp"

namespace rfm {

/// What a primitive contributes to a weight: its function, shaped as `WeightOptions` ask.
class WeightLiterals {
 public:
  /// Throws `InvalidArgument` where the options name no primitive of the region.
  WeightLiterals(const Region& region, const WeightOptions& options);

  /// ± the normalised function (minus where the primitive is subtracted), shaped.
  Field function(int primitive, bool negated) const;
  /// As a factor of a product: the level where nothing shapes it.
  Field factor(int primitive, bool negated) const;
  /// The formula of `function`.
  std::string text(int primitive, bool negated) const;

  /// An expression with negations at its leaves: R-functions of the shaped functions. These are
  /// divided by `size`, a length, and the result is multiplied by it, which changes nothing where
  /// operations are homogeneous: degrees of others grow as powers of the depth of an expression.
  Field combined(const BooleanExpression& expression, const RSystem& system, double size = 1) const;
  std::string combined_text(const BooleanExpression& expression, const RSystem& system,
                            double size = 1) const;

  /// The primitives of this name: itself, or the sides of the shape. Throws `InvalidArgument` for
  /// none.
  std::vector<int> named(const std::string& name) const;

 private:
  const Region& region_;
  const WeightOptions& options_;
  std::vector<double> scales_;
};

}  // namespace rfm
