#pragma once

#include <memory>
#include <vector>

#include "basis/global_space.hpp"
#include "core/field_source.hpp"

namespace rfm {

/// A linear combination Σ c_i f_i of the functions of a space as a field. It gives NaN outside the
/// box where these are valid (farther than 10⁻⁹ of a side). Its bounds are what the space tells.
class SpaceField final : public FieldSource {
 public:
  /// Throws `InvalidArgument` on a wrong number of coefficients.
  SpaceField(std::shared_ptr<const GlobalSpace> space, std::vector<double> coefficients);

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override { return space_->valid(); }

 private:
  std::shared_ptr<const GlobalSpace> space_;
  std::vector<double> coefficients_;
};

}  // namespace rfm
