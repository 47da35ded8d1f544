#include <gmock/gmock.h>

#include "tests/problems/solved_text.hpp"

namespace rfm {
namespace {

using testing::HasSubstr;

const std::string membrane =
    "dimension: 2\n"
    "geometry: {shapes: {sheet: {box: {min: [0, 0], max: [pi, pi]}}}, domain: sheet}\n"
    "physics: {type: membrane, tension: 1, density: 1}\n"
    "conditions: [{at: all, value: 0}]\n"
    "study: {type: eigen, count: 1}\n"
    "discretization: {basis: {bspline: 3, cells: 8}}\n";

TEST(Modes, AreThoseWithoutDataAndSaySo) {
  const ScalarSolution plain = test::solved(membrane);
  EXPECT_TRUE(plain.notes.empty());
  EXPECT_NEAR(plain.eigen->values[0], 2, 1e-4);
  for (const std::string change : {"conditions.0.value=1 + x", "physics.load=1"}) {
    const ScalarSolution loaded = test::solved(membrane, {change});
    EXPECT_NEAR(loaded.eigen->values[0], plain.eigen->values[0], 1e-12) << change;
    ASSERT_EQ(loaded.notes.size(), 1u) << change;
    EXPECT_THAT(loaded.notes[0], HasSubstr("of the equations without data")) << change;
  }
}

}  // namespace
}  // namespace rfm
