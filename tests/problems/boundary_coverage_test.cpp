#include "problems/boundary_coverage.hpp"

#include <gmock/gmock.h>

#include "problems/reader.hpp"

using namespace rfm;
using testing::ElementsAre;

namespace {

Problem plate_with(const std::string& conditions) {
  return read_problem(make_source("plate.yaml", R"(
dimension: 2
geometry:
  shapes:
    plate: {box: {min: [0, 0], max: [2, 1]}}
    hole: {circle: {center: [1, 0.5], radius: 0.25}}
  domain: plate - hole
physics: {type: poisson}
)" + conditions));
}

const std::vector<std::string> all_pieces = {"plate.left", "plate.right", "plate.bottom",
                                             "plate.top", "hole"};

std::vector<std::string> complaints(const Problem& problem,
                                    const std::vector<std::string>& pieces) {
  std::vector<std::string> messages;
  try {
    check_boundary_coverage(problem, pieces);
  } catch (const ProblemFileErrors& errors) {
    for (const Mistake& mistake : errors.mistakes)
      messages.push_back(mistake.place.text() + ": " + mistake.message);
  }
  return messages;
}

std::vector<int> claimants(const PieceConditions& piece) {
  std::vector<int> conditions;
  for (const PieceClaim& claim : piece.claims) conditions.push_back(claim.condition);
  return conditions;
}

}  // namespace

TEST(BoundaryCoverage, IsCompleteWhenEveryPieceHasACondition) {
  EXPECT_THAT(complaints(plate_with("conditions: [{at: all, value: 0}]"), all_pieces),
              ElementsAre());
  EXPECT_THAT(complaints(plate_with("conditions: [{at: plate, value: 0}, {at: rest, flux: 0}]"),
                         all_pieces),
              ElementsAre());
}
TEST(BoundaryCoverage, NamesThePiecesWithoutACondition) {
  EXPECT_THAT(complaints(plate_with("conditions: [{at: plate, value: 0}]"), all_pieces),
              ElementsAre("plate.yaml:9:1: the boundary part 'hole' has no condition"));
  EXPECT_THAT(complaints(plate_with("conditions: [{at: [hole, plate.left], value: 0}]"),
                         {"plate.left", "plate.right", "plate.top", "hole"}),
              ElementsAre("plate.yaml:9:1: the boundary parts 'plate.right', 'plate.top' have no "
                          "condition"));
}
TEST(BoundaryCoverage, RefusesConditionsWhereThereIsNoBoundary) {
  EXPECT_THAT(complaints(plate_with("conditions: [{at: hole, value: 0}, {at: rest, flux: 0}]"),
                         {"plate.left", "plate.right", "plate.bottom", "plate.top"}),
              ElementsAre("plate.yaml:9:19: 'hole' is not part of the boundary of the domain"));
}
TEST(BoundaryCoverage, AllowsARestWithNothingLeft) {
  EXPECT_THAT(
      complaints(plate_with("conditions: [{at: all, value: 0}, {at: rest, flux: 0}]"), all_pieces),
      ElementsAre());
}
TEST(BoundaryCoverage, AllowsAShapeSomeOfWhoseSidesAreCutOff) {
  EXPECT_THAT(complaints(plate_with("conditions: [{at: plate, value: 0}, {at: hole, flux: 0}]"),
                         {"plate.left", "hole"}),
              ElementsAre());
}

TEST(AssignConditions, PutsTheLargerPriorityFirst) {
  const Problem problem = plate_with(R"(
regions: {upper: {of: plate.left, where: y - 0.5}}
conditions:
  - {at: plate, value: 0}
  - {at: upper, flux: 1, priority: 1}
  - {at: hole, flux: 2}
)");
  const std::vector<PieceConditions> assigned = assign_conditions(problem, all_pieces);
  EXPECT_THAT(claimants(assigned[0]), ElementsAre(1, 0));  // plate.left: above, then the rest
  EXPECT_TRUE(assigned[0].claims[0].where);
  EXPECT_FALSE(assigned[0].claims[1].where);
  EXPECT_TRUE(assigned[0].is_covered);
  EXPECT_THAT(claimants(assigned[1]), ElementsAre(0));
  EXPECT_THAT(claimants(assigned[4]), ElementsAre(2));
}
TEST(AssignConditions, GivesTheRestWhatNoOtherNames) {
  const Problem problem = plate_with(R"(
regions: {upper: {of: plate.left, where: y - 0.5}}
conditions:
  - {at: rest, value: 0, priority: 5}
  - {at: [upper, hole], flux: 1}
)");
  const std::vector<PieceConditions> assigned = assign_conditions(problem, all_pieces);
  EXPECT_THAT(claimants(assigned[0]), ElementsAre(1, 0));  // the rest of plate.left
  EXPECT_THAT(claimants(assigned[1]), ElementsAre(0));
  EXPECT_THAT(claimants(assigned[4]), ElementsAre(1));  // nothing left of the hole
}
TEST(AssignConditions, TellsWhatOnlyEvaluationCanDecide) {
  const Problem problem = plate_with(R"(
regions: {upper: {of: plate.left, where: y - 0.5}, lower: {of: plate.left, where: 0.5 - y}}
conditions:
  - {at: upper, value: 0}
  - {at: lower, value: 1}
  - {at: [plate.right, plate.bottom, plate.top, hole], flux: 1}
)");
  EXPECT_THAT(complaints(problem, all_pieces), ElementsAre());
  const PieceConditions left = assign_conditions(problem, all_pieces)[0];
  EXPECT_THAT(claimants(left), ElementsAre(0, 1));
  EXPECT_FALSE(left.is_covered);
}
