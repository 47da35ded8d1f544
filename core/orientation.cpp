#include "core/orientation.hpp"

#include <array>
#include <cmath>

namespace rfm {
namespace {

// A number as a sum of doubles that do not overlap, the largest last: sums are exact.
class ExactSum {
 public:
  // Adds the product of two doubles with its rounding error.
  void add_product(double a, double b) {
    const double product = a * b;
    add(std::fma(a, b, -product));
    add(product);
  }
  int sign() const {
    for (int i = size_ - 1; i >= 0; --i)
      if (parts_[i] != 0) return parts_[i] > 0 ? 1 : -1;
    return 0;
  }

 private:
  void add(double term) {
    // Shewchuk's grow-expansion: the rounding errors stay behind as parts.
    for (int i = 0; i < size_; ++i) {
      const double sum = term + parts_[i];
      const double other = sum - term;
      parts_[i] = (term - (sum - other)) + (parts_[i] - other);
      term = sum;
    }
    parts_[size_++] = term;
  }

  std::array<double, 12> parts_{};
  int size_ = 0;
};

}  // namespace

int orientation(const Point& a, const Point& b, const Point& c) {
  const double left = (a[0] - c[0]) * (b[1] - c[1]), right = (a[1] - c[1]) * (b[0] - c[0]);
  const double determinant = left - right;
  constexpr double relative_error = (3 + 16 * 0x1p-53) * 0x1p-53;
  const double bound = relative_error * (std::fabs(left) + std::fabs(right));
  if (determinant > bound) return 1;
  if (determinant < -bound) return -1;
  ExactSum sum;  // a × b + b × c + c × a
  sum.add_product(a[0], b[1]);
  sum.add_product(-a[1], b[0]);
  sum.add_product(b[0], c[1]);
  sum.add_product(-b[1], c[0]);
  sum.add_product(c[0], a[1]);
  sum.add_product(-c[1], a[0]);
  return sum.sign();
}

}  // namespace rfm
