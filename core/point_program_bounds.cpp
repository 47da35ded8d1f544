#include <algorithm>
#include <vector>

#include "core/jet_functions.hpp"
#include "core/jet_piecewise.hpp"
#include "core/jet_powers.hpp"
#include "core/jet_third_side.hpp"
#include "core/point_program.hpp"
#include "core/quadric_model.hpp"

namespace rfm {
namespace {

// As `Interpreter::bounds` has them.
std::array<double, maximum_variables> radii(const Box& box, int dimension) {
  std::array<double, maximum_variables> radius{};
  for (int axis = 0; axis < dimension; ++axis) {
    const double middle = box.interval(axis).middle();
    radius[axis] = std::max(box.high[axis] - middle, middle - box.low[axis]) * (1 + 0x1p-50);
  }
  return radius;
}

template <class Number>
Number model_of(const QuadricEvaluator& quadric, const Box& box) {
  const QuadricModel model(quadric, box);
  Number result = Number::constant(model.value);
  for (int axis = 0; axis < Number::size - 1; ++axis) result.c[1 + axis] = model.slopes[axis];
  return result;
}

}  // namespace

template <int N>
FunctionBounds PointProgram::bounds_in(const Box& box) const {
  using Number = Jet<TaylorBound, N, 1>;
  static thread_local std::vector<Number> results(capacity);
  const TaylorBound::Frame frame(radii(box, N));
  Number* next = results.data();
  for (const Step& step : steps_) {
    const Number& a = results[step.first];
    const Number& b = results[step.second];
    switch (step.code) {
      case Code::constant:
        *next = Number(step.number);
        break;
      case Code::quadric:
        *next = model_of<Number>(quadrics_[step.first], box);
        break;
      case Code::x:
      case Code::y:
      case Code::z: {
        const int axis = static_cast<int>(step.code) - static_cast<int>(Code::x);
        *next = Number::variable(axis, TaylorBound::coordinate(box.interval(axis), axis));
        break;
      }
      case Code::add:
        *next = a + b;
        break;
      case Code::subtract:
        *next = a - b;
        break;
      case Code::multiply:
        *next = a * b;
        break;
      case Code::divide:
        *next = a / b;
        break;
      case Code::negate:
        *next = -a;
        break;
      case Code::scale:
        *next = scaled(TaylorBound(step.number), a);
        break;
      case Code::offset:
        *next = a;
        next->c[0] = next->c[0] + TaylorBound(step.number);
        break;
      case Code::square:
        *next = square(a);
        break;
      case Code::sqrt:
        *next = sqrt(a);
        break;
      case Code::exp:
        *next = exp(a);
        break;
      case Code::log:
        *next = log(a);
        break;
      case Code::sin:
        *next = sin(a);
        break;
      case Code::cos:
        *next = cos(a);
        break;
      case Code::hypot:
        *next = hypot(a, b);
        break;
      case Code::min:
        *next = min(a, b);
        break;
      case Code::max:
        *next = max(a, b);
        break;
    }
    ++next;
  }
  const Number& result = next[-1];
  FunctionBounds bounds;
  bounds.value = result.c[0].range;
  bounds.smooth = result.c[0].smooth;
  for (int axis = 0; axis < N; ++axis) {
    bounds.gradient[axis] = result.c[1 + axis].range;
    bounds.smooth = bounds.smooth && result.c[1 + axis].smooth;
  }
  return bounds;
}

FunctionBounds PointProgram::bounds(const Box& box) const {
  return dimension_ == 3   ? bounds_in<3>(box)
         : dimension_ == 2 ? bounds_in<2>(box)
                           : bounds_in<1>(box);
}

}  // namespace rfm
