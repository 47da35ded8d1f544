#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "core/jet.hpp"
#include "core/jet_shape.hpp"

namespace rfm {

/// The coefficients of a jet whose size is known at run time: few of them inside the object, more
/// on the heap.
template <class T>
class JetCoefficients {
 public:
  explicit JetCoefficients(int size) : size_(size) {
    if (size > inline_size) heap_.reset(new T[size]);
  }
  JetCoefficients(const JetCoefficients& other) : JetCoefficients(other.size_) {
    std::copy_n(other.begin(), size_, begin());
  }
  JetCoefficients(JetCoefficients&& other) noexcept
      : size_(other.size_), heap_(std::move(other.heap_)) {
    if (!heap_) std::copy_n(other.inline_, size_, inline_);
  }
  JetCoefficients& operator=(const JetCoefficients& other) {
    if (this == &other) return *this;
    if (size_ != other.size_ && other.size_ > inline_size) heap_.reset(new T[other.size_]);
    if (other.size_ <= inline_size) heap_.reset();
    size_ = other.size_;
    std::copy_n(other.begin(), size_, begin());
    return *this;
  }
  JetCoefficients& operator=(JetCoefficients&& other) noexcept {
    heap_ = std::move(other.heap_);
    size_ = other.size_;
    if (!heap_) std::copy_n(other.inline_, size_, inline_);
    return *this;
  }

  int size() const { return size_; }
  T* begin() { return heap_ ? heap_.get() : inline_; }
  const T* begin() const { return heap_ ? heap_.get() : inline_; }
  T* end() { return begin() + size_; }
  const T* end() const { return begin() + size_; }
  T& operator[](int i) { return begin()[i]; }
  const T& operator[](int i) const { return begin()[i]; }

 private:
  static constexpr int inline_size = 16;  // second order in four variables
  int size_;
  std::unique_ptr<T[]> heap_;
  T inline_[inline_size];
};

/// A jet (core/jet.hpp) in 1 to 4 variables and of order 0 to 16, both known at run time. All rules
/// written for `Jet<T, N, K>` hold for it; only the arithmetic of coefficients is defined anew
/// here, from tables at run time.
///
/// A jet made from a number is of order 0 and stands for a constant: it combines with jets of any
/// shape, whose further coefficients it lacks because they are zero. All other jets of an
/// expression must have one shape.
template <class T>
struct Jet<T, run_time, run_time> {
  const JetShape* shape;
  int size;
  JetCoefficients<T> c;

  Jet() : Jet(0.0) {}
  Jet(double number) : Jet(JetShape::get(1, 0)) { c[0] = T(number); }  // NOLINT: as in Jet
  /// The zero of a shape.
  explicit Jet(const JetShape& shape) : shape(&shape), size(shape.size()), c(size) {
    for (T& coefficient : c) coefficient = T(0.0);
  }
  static Jet constant(const T& value) {
    Jet jet;
    jet.c[0] = value;
    return jet;
  }
  static Jet variable(const JetShape& shape, int axis, const T& value) {
    Jet jet(shape);
    jet.c[0] = value;
    if (shape.order() >= 1) jet.c[1 + axis] = T(1.0);
    return jet;
  }

  int order() const { return shape->order(); }
  const T& value() const { return c[0]; }
  /// ∂^α f, with |α| ≤ order.
  T derivative(const MultiIndex& alpha) const {
    const int place = jet_index(shape->variables(), alpha);
    return place < size ? c[place] * T(factorial(alpha)) : T(0.0);
  }
};

template <class T>
using DynamicJet = Jet<T, run_time, run_time>;

/// Coefficient `i` of a jet; zero beyond its size.
template <class T>
T coefficient(const DynamicJet<T>& a, int i) {
  return i < a.size ? a.c[i] : T(0.0);
}

/// The shape of what two jets combine to.
template <class T>
const JetShape& common_shape(const DynamicJet<T>& a, const DynamicJet<T>& b) {
  return a.size >= b.size ? *a.shape : *b.shape;
}

template <class T>
DynamicJet<T> operator+(const DynamicJet<T>& a, const DynamicJet<T>& b) {
  if (a.size < b.size) return b + a;
  DynamicJet<T> sum = a;
  for (int i = 0; i < b.size; ++i) sum.c[i] = a.c[i] + b.c[i];
  return sum;
}

template <class T>
DynamicJet<T> operator-(const DynamicJet<T>& a) {
  DynamicJet<T> negative = a;
  for (int i = 0; i < a.size; ++i) negative.c[i] = -a.c[i];
  return negative;
}

template <class T>
DynamicJet<T> operator-(const DynamicJet<T>& a, const DynamicJet<T>& b) {
  if (a.size < b.size) return -b + a;
  DynamicJet<T> difference = a;
  for (int i = 0; i < b.size; ++i) difference.c[i] = a.c[i] - b.c[i];
  return difference;
}

template <class T>
DynamicJet<T> scaled(const T& factor, const DynamicJet<T>& a) {
  DynamicJet<T> product = a;
  for (int i = 0; i < a.size; ++i) product.c[i] = factor * a.c[i];
  return product;
}

/// Coefficient `result` of a product of jets; without its last term it is what the coefficients of
/// `a` before `result` contribute.
template <class T>
T convolution(const JetShape& shape, int result, bool with_last, const T* a, const T* b) {
  const auto terms = shape.product_terms(result);
  const std::size_t count = terms.size() - (with_last ? 0 : 1);
  // As in the compiled rules, a value is rounded before it is used further.
  T sum = result == 0 ? T(0.0) + a[0] * b[0] : a[terms[0].left] * b[terms[0].right];
  for (std::size_t i = 1; i < count; ++i) sum = sum + a[terms[i].left] * b[terms[i].right];
  return sum;
}

template <class T>
DynamicJet<T> operator*(const DynamicJet<T>& a, const DynamicJet<T>& b) {
  if (a.size == 1) return scaled(a.c[0], b);
  if (b.size == 1) return scaled(b.c[0], a);
  DynamicJet<T> product(*a.shape);
  for (int i = 0; i < product.size; ++i)
    product.c[i] = convolution(*a.shape, i, true, a.c.begin(), b.c.begin());
  return product;
}

template <class T>
DynamicJet<T> operator/(const DynamicJet<T>& a, const DynamicJet<T>& b) {
  DynamicJet<T> quotient(common_shape(a, b));
  quotient.c[0] = a.c[0] / b.c[0];
  for (int i = 1; i < quotient.size; ++i) {
    T rest = coefficient(a, i);
    if (b.size > 1)
      for (const auto& term : b.shape->product_terms(i))
        if (term.right != 0) rest = rest - quotient.c[term.left] * b.c[term.right];
    quotient.c[i] = rest / b.c[0];
  }
  return quotient;
}

template <class T>
DynamicJet<T> quadratic_root(const DynamicJet<T>& p, const DynamicJet<T>& r, const T& value) {
  const JetShape& shape = common_shape(p, r);
  DynamicJet<T> root(shape), factor(shape);
  root.c[0] = value;
  const T divisor = p.c[0] + (value + value);
  for (int i = 1; i < root.size; ++i) {
    const auto terms = shape.product_terms(i);
    T rest = coefficient(r, i) - value * coefficient(p, i);
    for (std::size_t k = 1; k + 1 < terms.size(); ++k)
      rest = rest - root.c[terms[k].left] * factor.c[terms[k].right];
    root.c[i] = rest / divisor;
    factor.c[i] = coefficient(p, i) + root.c[i];
  }
  return root;
}

template <class T>
void for_each_derivative(const DynamicJet<T>& a, const auto& solve) {
  for (int i = 1; i < a.size; ++i) solve(i);
}
template <class T>
T without_products(T rest, const DynamicJet<T>& a, const DynamicJet<T>& b, int i) {
  const auto terms = a.shape->product_terms(i);
  for (std::size_t k = 1; k + 1 < terms.size(); ++k)
    rest = rest - a.c[terms[k].left] * b.c[terms[k].right];
  return rest;
}
template <class T>
int degree_at(const DynamicJet<T>& a, const DynamicJet<T>& b, int i) {
  return degree(common_shape(a, b).exponent(i));
}
template <class T>
DynamicJet<T> constant_like(const DynamicJet<T>& a, const T& value) {
  DynamicJet<T> constant(*a.shape);
  constant.c[0] = value;
  return constant;
}

template <class T>
DynamicJet<T> compose(const DynamicJet<T>& a, const TaylorSeries<T, run_time>& taylor) {
  const int order = a.order();
  DynamicJet<T> result(*a.shape);
  result.c[0] = taylor[order];
  for (int degree = 1; degree <= order; ++degree) {
    for (int i = a.shape->size(degree) - 1; i > 0; --i)
      result.c[i] = convolution(*a.shape, i, false, result.c.begin(), a.c.begin());
    result.c[0] = taylor[order - degree];
  }
  return result;
}

template <class T>
DynamicJet<T> select(const auto& condition, const DynamicJet<T>& yes, const DynamicJet<T>& no) {
  DynamicJet<T> chosen(common_shape(yes, no));
  for (int i = 0; i < chosen.size; ++i)
    chosen.c[i] = select(condition, coefficient(yes, i), coefficient(no, i));
  return chosen;
}

/// Also the derivatives of a constant `f` are undefined where the argument is.
template <class T>
DynamicJet<T> nan_where_nan(const DynamicJet<T>& f, const DynamicJet<T>& argument) {
  DynamicJet<T> result(common_shape(f, argument));
  for (int i = 0; i < result.size; ++i)
    result.c[i] = nan_where_nan(coefficient(f, i), argument.c[0]);
  return result;
}

/// ∂a/∂(axis): one order less is meaningful, coefficients of the highest degree are zero.
template <class T>
DynamicJet<T> differentiate(const DynamicJet<T>& a, int axis) {
  DynamicJet<T> derivative(*a.shape);
  const int known = a.order() > 0 ? a.shape->size(a.order() - 1) : 0;
  for (int i = 0; i < known; ++i)
    derivative.c[i] = T(a.shape->exponent(i)[axis] + 1.0) * a.c[a.shape->raised(axis, i)];
  return derivative;
}

template <class T>
DynamicJet<T> own_variable(const DynamicJet<T>& a) {
  return DynamicJet<T>::variable(JetShape::get(1, std::max(a.order() - 1, 0)), 0, a.c[0]);
}

}  // namespace rfm
