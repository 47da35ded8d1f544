#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <vector>

#include "core/multi_index.hpp"

namespace rfm::reference {

/// Numbers of as many digits as `Real::default_precision` says when they are made (MPFR, whose
/// functions are correctly rounded).
using Real = boost::multiprecision::mpfr_float;

/// A truncated power series in up to three variables with coefficients of many digits. It shares
/// nothing with the jets that it judges but the order of coefficients (core/multi_index.hpp):
/// products are written out term by term, functions have the Taylor coefficients of textbooks,
/// inverse functions are integrals of their derivatives. A series of one coefficient is a constant
/// and combines with any other.
class PowerSeries {
 public:
  PowerSeries(double number = 0) : c{Real(number)} {}  // NOLINT: implicit
  PowerSeries(Real number) : c{std::move(number)} {}   // NOLINT: implicit
  PowerSeries(int variables, int order)
      : variables(variables), order(order), c(jet_size(variables, order)) {}
  static PowerSeries variable(int variables, int order, int axis, double value);

  const Real& value() const { return c[0]; }
  bool is_constant() const;

  int variables = 1, order = 0;
  std::vector<Real> c;
};

/// What was met while series were combined, since it was last cleared.
struct Incidents {
  bool corner = false;  ///< a place where an operation is not smooth
  bool cut = false;     ///< where the sign of a zero decides about the value
};
Incidents& incidents();

PowerSeries operator+(const PowerSeries& a, const PowerSeries& b);
PowerSeries operator-(const PowerSeries& a, const PowerSeries& b);
PowerSeries operator-(const PowerSeries& a);
PowerSeries operator*(const PowerSeries& a, const PowerSeries& b);
PowerSeries operator/(const PowerSeries& a, const PowerSeries& b);

bool operator<(const PowerSeries& a, const PowerSeries& b);
bool operator<=(const PowerSeries& a, const PowerSeries& b);
bool operator>(const PowerSeries& a, const PowerSeries& b);
bool operator>=(const PowerSeries& a, const PowerSeries& b);
bool operator==(const PowerSeries& a, const PowerSeries& b);
bool operator!=(const PowerSeries& a, const PowerSeries& b);

PowerSeries pow(const PowerSeries& a, const PowerSeries& b);
PowerSeries fabs(const PowerSeries& a);
PowerSeries floor(const PowerSeries& a);
PowerSeries floored_remainder(const PowerSeries& a, const PowerSeries& b);
PowerSeries sqrt(const PowerSeries& a);
PowerSeries cbrt(const PowerSeries& a);
PowerSeries exp(const PowerSeries& a);
PowerSeries log(const PowerSeries& a);
PowerSeries sin(const PowerSeries& a);
PowerSeries cos(const PowerSeries& a);
PowerSeries tan(const PowerSeries& a);
PowerSeries asin(const PowerSeries& a);
PowerSeries acos(const PowerSeries& a);
PowerSeries atan(const PowerSeries& a);
PowerSeries atan2(const PowerSeries& y, const PowerSeries& x);
PowerSeries sinh(const PowerSeries& a);
PowerSeries cosh(const PowerSeries& a);
PowerSeries tanh(const PowerSeries& a);
PowerSeries asinh(const PowerSeries& a);
PowerSeries erf(const PowerSeries& a);
PowerSeries hypot(const PowerSeries& a, const PowerSeries& b);

}  // namespace rfm::reference
