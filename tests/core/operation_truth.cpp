#include "tests/core/operation_truth.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/jet_shape.hpp"
#include "tests/core/power_series.hpp"

namespace rfm {
namespace {

using reference::PowerSeries, reference::Real;

PowerSeries definition(const Row& row, const PowerSeries& a, [[maybe_unused]] const PowerSeries& b,
                       [[maybe_unused]] const PowerSeries& c) {
  const PowerSeries number(row.number);
  switch (row.operation) {
#define RFM_REFERENCE(id, name, arity, numbers, rule, reference, ...) \
  case Operation::id:                                                 \
    return PowerSeries(reference);
    RFM_OPERATIONS(RFM_REFERENCE)
#undef RFM_REFERENCE
    default:
      return NAN;
  }
}

// Products of polynomials, coefficient by coefficient.
std::vector<double> product(const JetShape& shape, const std::vector<double>& a,
                            const std::vector<double>& b) {
  std::vector<double> result(a.size());
  for (int i = 0; i < shape.size(); ++i)
    for (int j = 0; j < shape.size(); ++j) {
      const MultiIndex sum = shape.exponent(i) + shape.exponent(j);
      if (degree(sum) <= shape.order()) result[jet_index(shape.variables(), sum)] += a[i] * b[j];
    }
  return result;
}

}  // namespace

namespace {

// The Taylor coefficients of the definition in its own arguments, with so many digits.
std::vector<Real> series_of(const Row& row, int arity, const std::array<double, 3>& arguments,
                            int order, unsigned digits) {
  Real::default_precision(digits);
  std::vector<PowerSeries> own(3);
  for (int i = 0; i < arity; ++i) own[i] = PowerSeries::variable(arity, order, i, arguments[i]);
  reference::incidents() = {};
  PowerSeries f = definition(row, own[0], own[1], own[2]);
  f.c.resize(jet_size(arity, order));  // of a constant
  return f.c;
}

// The product of the |a|^±power over the arguments, if there are several.
long double farthest_power(const std::array<double, 3>& arguments, int arity, int power) {
  long double farthest = 1;
  for (int i = 0; arity > 1 && i < arity; ++i)
    if (arguments[i] != 0)
      farthest *= std::exp2(
          power * std::fabs(std::log2(std::fabs(static_cast<long double>(arguments[i])))));
  return farthest;
}

}  // namespace

OperationTruth truth_of(const Row& row, const std::array<double, 3>& arguments, int order) {
  OperationTruth truth;
  truth.arity = find_operation(row.operation)->arity;
  truth.order = order;
  // What the digits cancel shows in a second evaluation with fewer of them.
  constexpr unsigned digits = 700, fewer = 350;
  const std::vector<Real> rough = series_of(row, truth.arity, arguments, order + 1, fewer);
  const std::vector<Real> f = series_of(row, truth.arity, arguments, order + 1, digits);
  truth.is_smooth = !reference::incidents().corner;
  truth.is_cut = reference::incidents().cut;
  const JetShape& shape = JetShape::get(truth.arity, order + 1);
  const auto at = [&](const MultiIndex& alpha) {
    return static_cast<long double>(f[jet_index(truth.arity, alpha)]);
  };
  constexpr long double least = std::numeric_limits<double>::min();
  constexpr long double largest = std::numeric_limits<double>::max();
  for (int i = 0; i < shape.size(order); ++i) {
    const MultiIndex alpha = shape.exponent(i);
    truth.coefficients.push_back(at(alpha));
    long double weight = std::fabs(at(alpha));
    for (int axis = 0; axis < truth.arity; ++axis) {
      const long double next = at(alpha + unit_index(axis));
      const long double size =
          std::max(std::fabs(static_cast<long double>(arguments[axis])), least);
      if (!std::isnan(next)) weight += std::fabs(size * (alpha[axis] + 1) * next);
    }
    truth.weights.push_back(weight);
    const Real lost = abs(Real(f[i] - rough[i])) * pow(Real(10), -static_cast<int>(fewer) + 20);
    truth.is_known.push_back(lost <= 1e-20L * weight);
  }
  truth.is_defined = boost::multiprecision::isfinite(f[0]);
  for (int i = 1; truth.is_defined && i < shape.size(order); ++i)
    truth.is_smooth = truth.is_smooth && !std::isnan(truth.coefficients[i]);
  for (int degree = 0; degree <= order; ++degree) {
    const long double power = farthest_power(arguments, truth.arity, degree);
    bool overflows = power >= largest;
    truth.least.push_back(least * power);
    for (int i = 0; i < shape.size(degree); ++i)
      overflows = overflows || !(truth.weights[i] < largest);
    truth.overflows.push_back(overflows);
  }
  return truth;
}

ArgumentShape ArgumentShape::own(int variables, int order) {
  ArgumentShape shape{variables, order, Kind::own, {}};
  for (int i = 0; i < 3; ++i) {
    shape.coefficients[i].assign(jet_size(variables, order), 0);
    if (i < variables && order > 0) shape.coefficients[i][1 + i] = 1;
  }
  return shape;
}

ArgumentShape ArgumentShape::mixed(int variables, int order) {
  ArgumentShape shape = own(variables, order);
  shape.kind = Kind::mixed;
  const double linear[3][4] = {{1, -2, 0.5, 1}, {0.5, 1, -1, 2}, {-1, 0.5, 1, -0.5}};
  const double bent[3] = {0.5, -1, 2};
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < variables; ++axis) {
      std::vector<double>& c = shape.coefficients[i];
      if (order > 0) c[1 + axis] = linear[i][axis];
      if (order > 1)
        c[jet_index(variables, unit_index(axis) + unit_index(0))] = bent[i] / (1 + axis);
    }
  return shape;
}

ArgumentShape ArgumentShape::proportional(int variables, int order) {
  ArgumentShape shape = own(variables, order);
  shape.kind = Kind::proportional;
  const double linear[3][4] = {{1, -2, 1, 1}, {-1, 1, 2, 1}, {2, 1, -1, -1}};
  const double bent[3] = {1, -1, 2};
  for (int i = 0; i < 3; ++i)
    for (int axis = 0; axis < variables; ++axis) {
      std::vector<double>& c = shape.coefficients[i];
      if (order > 0) c[1 + axis] = linear[i][axis];
      if (order > 1) c[jet_index(variables, unit_index(axis) + unit_index(0))] = bent[i];
    }
  return shape;
}

Composition::Composition(const ArgumentShape& shape, int arity)
    : kind_(shape.kind),
      variables_(shape.variables),
      order_(shape.order),
      arity_(arity),
      size_(jet_size(shape.variables, shape.order)) {
  const JetShape& outer = JetShape::get(arity, shape.order);
  const JetShape& inner = JetShape::get(shape.variables, shape.order);
  std::array<std::vector<double>, 3> sizes = shape.coefficients;
  for (auto& coefficients : sizes)
    for (double& c : coefficients) c = std::fabs(c);
  for (int i = 0; i < outer.size(); ++i) {
    std::vector<double> monomial(size_), majorant(size_);
    monomial[0] = majorant[0] = 1;
    for (int axis = 0; axis < arity; ++axis)
      for (int k = 0; k < outer.exponent(i)[axis]; ++k) {
        monomial = product(inner, monomial, shape.coefficients[axis]);
        majorant = product(inner, majorant, sizes[axis]);
      }
    monomials_.push_back(std::move(monomial));
    majorants_.push_back(std::move(majorant));
    degrees_.push_back(shape.kind == ArgumentShape::Kind::own ? 0 : jet_degree(arity, i));
  }
}

long double Composition::weight(const OperationTruth& truth, std::size_t alpha) const {
  return truth.weights[alpha] + degrees_[alpha] * std::fabs(truth.coefficients[alpha]);
}

double largest_of(const std::array<double, 3>& arguments, int arity) {
  double largest = 0;
  for (int i = 0; i < arity; ++i) largest = std::max(largest, std::fabs(arguments[i]));
  return largest;
}

// f = Σ aᵢ ∂ᵢf, for several arguments.
bool is_of_degree_one(const OperationTruth& truth, const std::array<double, 3>& arguments) {
  if (truth.arity == 1 || truth.order == 0) return false;
  long double rest = truth.coefficients[0];
  for (int i = 0; i < truth.arity; ++i) rest -= arguments[i] * truth.coefficients[1 + i];
  return std::fabs(rest) <= 1e-15L * std::fabs(truth.coefficients[0]);
}

std::vector<Expected> Composition::of_proportional(const OperationTruth& truth,
                                                   const std::array<double, 3>& arguments) const {
  constexpr long double least = std::numeric_limits<double>::min();
  const JetShape& outer = JetShape::get(arity_, order_);
  std::vector<Expected> expected(size_);
  for (std::size_t alpha = 0; alpha < monomials_.size(); ++alpha) {
    long double factor = 1, size = 1;
    for (int axis = 0; axis < arity_; ++axis)
      for (int k = 0; k < outer.exponent(static_cast<int>(alpha))[axis]; ++k) {
        factor *= arguments[axis];
        size *= std::max(std::fabs(static_cast<long double>(arguments[axis])), least);
      }
    for (int i = 0; i < size_; ++i) {
      if (majorants_[alpha][i] == 0) continue;
      if (factor != 0)
        expected[i].value += truth.coefficients[alpha] * factor * monomials_[alpha][i];
      expected[i].condition += weight(truth, alpha) * size * majorants_[alpha][i];
      expected[i].least += least * majorants_[alpha][i];
      expected[i].is_known = expected[i].is_known && truth.is_known[alpha];
    }
  }
  if (is_of_degree_one(truth, arguments))
    for (Expected& coefficient : expected)
      coefficient.least *= std::max(1.0, largest_of(arguments, arity_));
  bool overflows = false;
  for (int i = 0; i < size_; ++i) {
    overflows = overflows || !(expected[i].condition < std::numeric_limits<double>::max());
    for (int k = i; k < size_ && jet_degree(variables_, k) == jet_degree(variables_, i); ++k)
      overflows = overflows || !(expected[k].condition < std::numeric_limits<double>::max());
    expected[i].overflows = overflows;
  }
  return expected;
}

std::vector<Expected> Composition::operator()(const OperationTruth& truth,
                                              const std::array<double, 3>& arguments) const {
  if (kind_ == ArgumentShape::Kind::proportional) return of_proportional(truth, arguments);
  std::vector<Expected> expected(size_);
  for (std::size_t alpha = 0; alpha < monomials_.size(); ++alpha)
    for (int i = 0; i < size_; ++i) {
      if (majorants_[alpha][i] == 0) continue;
      expected[i].value += truth.coefficients[alpha] * monomials_[alpha][i];
      expected[i].condition += weight(truth, alpha) * majorants_[alpha][i];
      expected[i].is_known = expected[i].is_known && truth.is_known[alpha];
    }
  for (int i = 0; i < size_; ++i) {
    expected[i].overflows = truth.overflows[jet_degree(variables_, i)];
    expected[i].least = truth.least[jet_degree(variables_, i)];
  }
  return expected;
}

}  // namespace rfm
