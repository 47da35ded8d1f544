#include "core/point_program.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/scalar.hpp"

namespace rfm {
namespace {

// Value, ∂x, ∂y, ∂z.
using Slopes [[gnu::vector_size(4 * sizeof(double))]] = double;

// The rules for three kinds of number.
struct Plain {
  using Number = double;
  static Number constant(double number) { return number; }
  static Number coordinate(double x, int) { return x; }
  static Number quadric(const QuadricEvaluator& q, const Point& point) { return q.value(point); }
  static Number multiply(Number a, Number b) { return a * b; }
  static Number divide(Number a, Number b) { return a / b; }
  static double value(Number a) { return a; }
  static Number chain(Number, double f, double) { return f; }
};

struct WithSlope {
  struct Number {
    double value, slope;

    friend Number operator+(const Number& a, const Number& b) {
      return {a.value + b.value, a.slope + b.slope};
    }
    friend Number operator-(const Number& a, const Number& b) {
      return {a.value - b.value, a.slope - b.slope};
    }
    friend Number operator-(const Number& a) { return {-a.value, -a.slope}; }
    friend Number operator*(double number, const Number& a) {
      return {number * a.value, number * a.slope};
    }
  };
  int axis;

  static Number constant(double number) { return {number, 0}; }
  Number coordinate(double x, int index) const { return {x, index == axis ? 1.0 : 0.0}; }
  Number quadric(const QuadricEvaluator& q, const Point& point) const {
    return {q.value(point), q.slope(point, axis)};
  }
  static Number multiply(const Number& a, const Number& b) {
    return {a.value * b.value, a.value * b.slope + b.value * a.slope};
  }
  static Number divide(const Number& a, const Number& b) {
    const double quotient = a.value / b.value;
    return {quotient, (a.slope - quotient * b.slope) / b.value};
  }
  static double value(const Number& a) { return a.value; }
  static Number chain(const Number& a, double f, double slope) { return {f, a.slope * slope}; }
};

struct WithGradient {
  using Number = Slopes;
  static Number constant(double number) { return Number{number, 0, 0, 0}; }
  static Number coordinate(double x, int axis) {
    Number result{x, 0, 0, 0};
    result[1 + axis] = 1;
    return result;
  }
  static Number quadric(const QuadricEvaluator& q, const Point& point) {
    return Number{q.value(point), q.slope(point, 0), q.slope(point, 1), q.slope(point, 2)};
  }
  static Number multiply(const Number& a, const Number& b) {
    Number result = a[0] * b + b[0] * a;
    result[0] = a[0] * b[0];
    return result;
  }
  static Number divide(const Number& a, const Number& b) {
    const double quotient = a[0] / b[0];
    Number result = (a - quotient * b) * (1 / b[0]);
    result[0] = quotient;
    return result;
  }
  static double value(const Number& a) { return a[0]; }
  static Number chain(const Number& a, double f, double slope) {
    Number result = a * slope;
    result[0] = f;
    return result;
  }
};

}  // namespace

template <class Rules>
typename Rules::Number PointProgram::run(const Rules& rules, const Point& point) const {
  using Number = typename Rules::Number;
  Number results[capacity];
  Number* next = results;
  for (const Step& step : steps_) {
    const Number& a = results[step.first];
    const Number& b = results[step.second];
    switch (step.code) {
      case Code::constant:
        *next = Rules::constant(step.number);
        break;
      case Code::quadric:
        *next = rules.quadric(quadrics_[step.first], point);
        break;
      case Code::x:
      case Code::y:
      case Code::z: {
        const int axis = static_cast<int>(step.code) - static_cast<int>(Code::x);
        *next = rules.coordinate(point[axis], axis);
        break;
      }
      case Code::add:
        *next = a + b;
        break;
      case Code::subtract:
        *next = a - b;
        break;
      case Code::multiply:
        *next = Rules::multiply(a, b);
        break;
      case Code::divide:
        *next = Rules::divide(a, b);
        break;
      case Code::negate:
        *next = -a;
        break;
      case Code::scale:
        *next = step.number * a;
        break;
      case Code::offset:
        *next = a + Rules::constant(step.number);
        break;
      case Code::square: {
        const double value = Rules::value(a);
        *next = Rules::chain(a, value * value, 2 * value);
        break;
      }
      case Code::sqrt: {
        const double root = std::sqrt(Rules::value(a));
        *next = Rules::chain(a, root, root == 0 ? 0.0 : 0.5 / root);
        break;
      }
      case Code::exp: {
        const double value = std::exp(Rules::value(a));
        *next = Rules::chain(a, value, value);
        break;
      }
      case Code::log:
        *next = Rules::chain(a, std::log(Rules::value(a)),
                             Rules::value(a) < 0 ? NAN : 1 / Rules::value(a));
        break;
      case Code::sin:
        *next = Rules::chain(a, std::sin(Rules::value(a)), std::cos(Rules::value(a)));
        break;
      case Code::cos:
        *next = Rules::chain(a, std::cos(Rules::value(a)), -std::sin(Rules::value(a)));
        break;
      case Code::hypot: {
        const double root = std::hypot(Rules::value(a), Rules::value(b));
        const double part_a = root == 0 ? 0.0 : Rules::value(a) / root;
        const double part_b = root == 0 ? 0.0 : Rules::value(b) / root;
        *next = Rules::chain(part_a * a + part_b * b, root, 1);
        break;
      }
      case Code::min:
        *next = less_or_nan(Rules::value(b), Rules::value(a)) ? b : a;
        break;
      case Code::max:
        *next = greater_or_nan(Rules::value(b), Rules::value(a)) ? b : a;
        break;
    }
    ++next;
  }
  return next[-1];
}

double PointProgram::value(const Point& point) const { return run(Plain(), point); }

double PointProgram::value_and_slope(const Point& point, int axis, double& slope) const {
  const WithSlope::Number result = run(WithSlope{axis}, point);
  slope = result.slope;
  return result.value;
}

double PointProgram::value_and_gradient(const Point& point, Point& gradient) const {
  const Slopes result = run(WithGradient(), point);
  gradient = {result[1], result[2], result[3]};
  return result[0];
}

}  // namespace rfm
