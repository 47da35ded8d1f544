#pragma once

#include <vector>

#include "core/field.hpp"
#include "core/multi_index.hpp"

namespace rfm {

/// All derivatives of a field at one point, up to an order chosen at run time.
class PointJet {
 public:
  PointJet(int dimension, int order, std::vector<double> coefficients)
      : dimension_(dimension), order_(order), coefficients_(std::move(coefficients)) {}
  double value() const { return coefficients_[0]; }
  /// ∂^(i+j+k) f / ∂xⁱ ∂yʲ ∂zᵏ. Throws `InvalidArgument` beyond the order and the variables.
  double derivative(int i, int j = 0, int k = 0) const;

 private:
  int dimension_;
  int order_;
  std::vector<double> coefficients_;
};

/// The value at one point. For single points and tests: each call compiles a tape.
double value_at(const Field& field, const Point& point, double time = 0);
/// Value and derivatives up to `order` at one point, in `dimension` variables.
PointJet evaluate(const Field& field, const Point& point, int order, int dimension = 3);

}  // namespace rfm
