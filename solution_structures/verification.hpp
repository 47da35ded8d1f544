#pragma once

#include <functional>
#include <span>
#include <vector>

#include "core/box.hpp"
#include "core/field.hpp"
#include "solution_structures/structure.hpp"

namespace rfm {

/// B: what a boundary condition makes of the components of a solution, u ↦ B u.
using BoundaryOperator = std::function<Field(const std::vector<Field>& u)>;

struct StructureTrials {
  int dimension = 2;
  int count = 3;      ///< sets of functions that are put in for the Ψ
  unsigned seed = 1;  ///< the same seed gives the same functions everywhere
  /// What functions are multiplied by. With 0 nothing is put in: u is what the structure makes of
  /// the data, be they ever so small.
  double amplitude = 1;
  /// Functions are those of (x − centre)/size: of a domain in other units the same ones.
  Point centre{};
  double size = 1;
};

struct StructureDeviation {
  static constexpr int of_data = -1;
  double largest = 0;  ///< |B u − data|; not a number where that is not
  Point place{};       ///< where
  int trial = 0;       ///< for which functions; `of_data` for none
  double scale = 1;    ///< how large it is where it need not be zero, if that is known
};

/// A function to put in for a Ψ: a polynomial of degree 4 with coefficients of at most 1, and a
/// sine in a direction of its own, of (x − centre)/size. Smooth, and of no boundary condition of
/// ours.
Field random_function(int dimension, unsigned seed, const Point& centre = {}, double size = 1);

/// How far a structure is from a boundary condition: the largest |B u − data| over `points`
/// (regular points of the part of the boundary), with random functions in the place of the Ψ. A
/// structure is right if this is rounding, whatever it is made of: the builder does not come into
/// it.
///
///     largest_deviation({neumann}, [&](const auto& u) { return dot(normal, gradient(u[0], 2)); },
///                       flux, points)
///
/// Throws `InvalidArgument` without points.
StructureDeviation largest_deviation(const std::vector<Structure>& structures,
                                     const BoundaryOperator& condition, const Field& data,
                                     std::span<const Point> points,
                                     const StructureTrials& trials = {});

/// u with random functions in the place of the Ψ, those of one trial.
std::vector<Field> random_solution(const std::vector<Structure>& structures,
                                   const StructureTrials& trials, int trial = 0);
std::vector<Field> random_solution(const std::vector<Structure>& structures, int dimension,
                                   unsigned seed);

}  // namespace rfm
