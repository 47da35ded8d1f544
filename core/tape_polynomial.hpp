#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/tape_step.hpp"

namespace rfm {

struct Instruction;

/// A polynomial of degree ≤ 2 recognised in an instruction of a tape and all below it:
/// c + b·t + tᵀAt with t = x − origin, x the (at most three) variables of the jets. Origins are
/// those of the expression, (x − 3)² has 3, so that a small circle far away loses no digits. Its
/// derivatives are known in closed form: the gradient b + 2At, a constant Hessian, nothing beyond;
/// only the value needs the operations of the expression.
///
/// Many expressions are a single sum ±(c + Σ kᵢ tᵢ^pᵢ), pᵢ ≤ 2, of at most one term per coordinate,
/// times a factor: half-spaces, circles, spheres, axis-parallel cylinders. They are `summable`: one
/// step computes the value with the very operations of the expression in their order, hence with
/// the same rounding, bit by bit; zeros that are exact stay so.
struct Polynomial {
  static constexpr int square_index(int i, int j) {
    constexpr int index[3][3] = {{0, 1, 2}, {1, 3, 4}, {2, 4, 5}};
    return index[i][j];
  }
  /// A sum of `count` terms over distinct axes, in the order in which they are added.
  struct Sum {
    int count = 0;
    std::array<int, 3> axis{};
    std::array<double, 3> factor{};
    std::array<bool, 3> squared{};
    double first = 0, last = 0;  ///< the constant, added before or after the terms
    double scale = 1;            ///< of the whole sum
  };

  std::array<double, 3> origin{};
  double constant = 0;
  std::array<double, 3> linear{};
  std::array<double, 6> square{};  ///< A: xx, xy, xz, yy, yz, zz
  bool summable = false;
  Sum sum;

  bool is_affine() const { return square == std::array<double, 6>{}; }
  bool depends_on(int axis) const;
};

/// The polynomial of `instruction`, given those of the instructions before it: in constant time.
std::optional<Polynomial> recognise(const Instruction& instruction,
                                    const std::vector<const Polynomial*>& known);

// Steps for polynomials. Their arguments are the rows of coordinates; compiled without contraction
// of products and sums, which would round differently from the expression.

/// The value of a sum of linear terms: argument k is the coordinate of term k, constants are
/// scale, first, last, then factor and origin of each term.
Kernel affine_kernel(int terms);
/// The value of a sum of linear and quadratic terms of N coordinates, and its gradient if asked:
/// constants are scale, first, last, then (origin, linear, quadratic factor) for each argument; the
/// axis of argument k is in bits 2k of `index`.
Kernel quadratic_sum_kernel(int dimension, bool with_gradient);
/// The gradient b + 2At: constants are b and the rows of 2A, each followed by the origin.
Kernel quadric_gradient_kernel(int dimension);

}  // namespace rfm
