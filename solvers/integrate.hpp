#pragma once

#include <span>
#include <vector>

#include "core/field.hpp"
#include "quadrature/domain_rule.hpp"
#include "solvers/field_arguments.hpp"
#include "solvers/integrand.hpp"

namespace rfm {

/// Where to integrate: the volume, or pieces of the boundary or interfaces.
struct IntegrationPlace {
  Contribution::Place place = Contribution::Place::volume;
  /// Primitives or interfaces whose pieces count; none means all.
  std::vector<int> numbers{};
};

/// ∫ f over a place, for several fields at once: the integrand may depend on the normal on
/// surfaces. Sums are compensated and taken in a fixed order, whatever the number of threads.
/// Throws `ComputationError` where a value is not finite.
std::vector<double> integrate(std::span<const Coefficient> integrands, const DomainRule& rule,
                              const IntegrationPlace& place = {},
                              const FieldArguments& arguments = {});
double integrate(const Coefficient& integrand, const DomainRule& rule,
                 const IntegrationPlace& place = {}, const FieldArguments& arguments = {});

/// max |f| over the points of a rule: a lower bound of the maximum norm. 0 for a rule without
/// points.
double maximum(const Field& field, const DomainRule& rule, const IntegrationPlace& place = {},
               const FieldArguments& arguments = {});

/// Norms of a field over the volume.
struct FieldNorms {
  double l2 = 0;           ///< √∫ f²
  double h1_seminorm = 0;  ///< √∫ |∇f|²
  double maximum = 0;      ///< over the points of the rule
  double h1() const;       ///< √∫ (f² + |∇f|²)
};
FieldNorms norms(const Field& field, const DomainRule& rule, const FieldArguments& arguments = {});

}  // namespace rfm
