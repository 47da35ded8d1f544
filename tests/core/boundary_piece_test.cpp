#include "core/boundary_piece.hpp"

#include <gtest/gtest.h>

#include "core/bounding_box.hpp"
#include "core/evaluate.hpp"
#include "core/primitives.hpp"

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();

std::vector<BoundaryPiece> pieces_of(const Region& region) {
  const RegionEvaluator evaluator(region);
  const Box bounds = bounding_box(evaluator);
  std::vector<BoundaryPiece> pieces;
  for (int k = 0; k < evaluator.primitive_count(); ++k)
    pieces.push_back(boundary_piece(k, evaluator, bounds));
  return pieces;
}

TEST(BoundaryPiece, CirclesOfARingAreWholeAndPositiveInside) {
  const auto pieces =
      pieces_of(circle({0, 0}, 1).named("outer") - circle({0, 0}, 0.4).named("hole"));
  for (const BoundaryPiece& piece : pieces) {
    EXPECT_TRUE(piece.whole);
    EXPECT_GT(value_at(piece.function, {0, 0.7, 0}), 0);
  }
  EXPECT_NEAR(value_at(pieces[1].function, {0.4, 0, 0}), 0, 1e-16);
}

TEST(BoundaryPiece, EdgesOfAReentrantCornerAreTrimmedToThePiece) {
  // The line x = 1 bounds the L-shape for y > 1 and runs through its inside for y < 1.
  const auto pieces =
      pieces_of(box({0, 0}, {2, 2}).named("whole") - box({1, 1}, {3, 3}).named("notch"));
  const auto left = std::find_if(pieces.begin(), pieces.end(), [](const BoundaryPiece& piece) {
    return piece.name == "notch.left";
  });
  ASSERT_NE(left, pieces.end());
  EXPECT_FALSE(left->whole);
  EXPECT_NEAR(value_at(left->function, {1, 1.5, 0}), 0, 1e-15);
  EXPECT_GT(value_at(left->function, {1, 0.5, 0}), 0.1);
  EXPECT_GT(value_at(left->function, {0.5, 1.5, 0}), 0.1);
}

TEST(Trim, IsZeroOnThePieceAloneAndNormalizedThere) {
  const Field piece = trim(x, y);  // the half line x = 0, y ≥ 0
  EXPECT_EQ(value_at(piece, {0, 0.5, 0}), 0);
  EXPECT_GT(value_at(piece, {0, -0.5, 0}), 0.4);
  EXPECT_NEAR(evaluate(piece, {1e-9, 0.5, 0}, 1, 2).derivative(1, 0), 1, 1e-12);
  EXPECT_NEAR(evaluate(piece, {1e-9, 0.5, 0}, 1, 2).derivative(0, 1), 0, 1e-12);
  // Where λ > 0 the stable form keeps all digits of |γ|.
  EXPECT_DOUBLE_EQ(value_at(piece, {1e-12, 0.5, 0}), 1e-12);
}

}  // namespace
