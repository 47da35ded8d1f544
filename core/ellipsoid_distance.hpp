#pragma once

#include "core/field_source.hpp"

namespace rfm {

/// The signed distance from an ellipse or ellipsoid in its own axes: see `ellipsoid_distance`.
class EllipsoidDistance final : public FieldSource {
 public:
  EllipsoidDistance(const Point& radii, int dimension);

  void evaluate(const std::array<const double*, 3>& coordinates, int count, int variables,
                int order, double* jets, int stride) const override;
  /// Slopes by the multiplier t, which grows with every |x_i|: −p / |p| with p_i = x_i / (t +
  /// a_i²); the value by that at the centre and the slopes.
  FunctionBounds bounds(const Box& box) const override;
  std::vector<double> breakpoints(int axis) const override;
  Box valid() const override;

 private:
  struct Root {
    double t;       ///< the multiplier of the nearest point
    bool on_focal;  ///< the nearest point is not unique
  };
  Root root(const Point& point) const;
  double distance(const Point& point, const Root& root) const;
  std::array<Interval, maximum_variables> gradient(const Box& box, bool& smooth) const;

  int dimension_;
  std::array<double, 3> radii_{}, squares_{};
  int thinnest_ = 0;  ///< the axis of the smallest radius
};

}  // namespace rfm
