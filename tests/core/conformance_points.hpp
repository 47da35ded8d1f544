#pragma once

#include <random>
#include <vector>

#include "tests/core/conformance_evaluators.hpp"

namespace rfm {

/// The rows of the table, each with all of a list of numbers that it takes: new rows join by
/// themselves.
std::vector<Row> conformance_rows();

/// Arguments that are nasty for some operation: zeros of both signs, denormals, ±1e300, ends of
/// domains, multiples of π/2, whole numbers and the neighbours of all of these; and among them, at
/// all scales, random ones, equal ones and nearly equal ones: a seeded sample, half of it special
/// until all special numbers are in.
std::vector<Arguments> nasty_arguments(int arity, int count, std::mt19937_64& generator);

/// Half of them nasty, the others of every size from 1e-300 to 1e300, often alike in it.
std::vector<Arguments> arguments_of_every_size(int arity, int count, std::mt19937_64& generator);

}  // namespace rfm
