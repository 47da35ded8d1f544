#pragma once

#include <initializer_list>
#include <vector>

namespace rfm {

/// The coordinates in which the jets of a tape are taken: its variables.
class Variables {
 public:
  /// The first `dimension` of x, y, z; of these three, the others are 0 for all points.
  Variables(int dimension);  // NOLINT: implicit
  /// One to four different coordinates, by number (0 to 2 for x, y, z, 3 for the time, then
  /// further ones). All other coordinates have the values that an evaluation is given.
  Variables(std::initializer_list<int> coordinates);
  explicit Variables(std::vector<int> coordinates);

  int count() const { return static_cast<int>(coordinates_.size()); }
  const std::vector<int>& coordinates() const { return coordinates_; }
  /// Which variable a coordinate is; −1 if it is none.
  int find(int coordinate) const;
  /// Whether a coordinate is 0 for all points.
  bool vanishes(int coordinate) const {
    return rest_vanishes_ && coordinate < 3 && find(coordinate) < 0;
  }
  /// Whether the variables are the first of x, y, z, in this order.
  bool are_leading() const;

 private:
  std::vector<int> coordinates_;
  bool rest_vanishes_ = false;
};

}  // namespace rfm
