#include "core/trim.hpp"

namespace rfm {
namespace {

Field trimmed(const Field& gamma, const Field& within, const Field& lambda) {
  const Field root = hypot(lambda, gamma * gamma);
  const Field beside = sqrt(1 + 0.25 * pow(pow(gamma, 3) / (root + lambda), 2));
  const Field beyond = hypot(gamma, 0.5 * (root - lambda));
  return select(apply(Operation::less, {0.0, lambda}), within * beside, beyond);
}

}  // namespace

Field trim(const Field& gamma, const Field& lambda) { return trimmed(gamma, abs(gamma), lambda); }

Field trim_from_inside(const Field& gamma, const Field& lambda) {
  return trimmed(gamma, gamma, lambda);
}

Field trim_of_square(const Field& square, const Field& lambda) {
  const Field root = hypot(lambda, square);
  const Field beside = sqrt(square * (1 + 0.25 * square * pow(square / (root + lambda), 2)));
  const Field beyond = sqrt(square + 0.25 * pow(root - lambda, 2));
  return select(apply(Operation::less, {0.0, lambda}), beside, beyond);
}

}  // namespace rfm
