#include "core/trim.hpp"

namespace rfm {
namespace {

// γ / l or `within` / l, and λ / l, in lengths of l.
Field trimmed(const Field& gamma, const Field& within, const Field& lambda) {
  const Field root = hypot(lambda, gamma * gamma);
  const Field beside = sqrt(1 + 0.25 * pow(pow(gamma, 3) / (root + lambda), 2));
  const Field beyond = hypot(gamma, 0.5 * (root - lambda));
  return select(apply(Operation::less, {0.0, lambda}), within * beside, beyond);
}

}  // namespace

Field trim(const Field& gamma, const Field& lambda, double length) {
  const Field in_lengths = gamma / length;
  return length * trimmed(in_lengths, abs(in_lengths), lambda / length);
}

Field trim_from_inside(const Field& gamma, const Field& lambda, double length) {
  const Field in_lengths = gamma / length;
  return length * trimmed(in_lengths, in_lengths, lambda / length);
}

Field trim_of_square(const Field& square, const Field& lambda, double length) {
  const Field gamma = square / (length * length), within = lambda / length;
  const Field root = hypot(within, gamma);
  const Field beside = sqrt(gamma * (1 + 0.25 * gamma * pow(gamma / (root + within), 2)));
  const Field beyond = sqrt(gamma + 0.25 * pow(root - within, 2));
  return length * select(apply(Operation::less, {0.0, within}), beside, beyond);
}

}  // namespace rfm
