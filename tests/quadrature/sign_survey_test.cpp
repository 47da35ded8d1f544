#include "quadrature/sign_survey.hpp"

#include <gmock/gmock.h>

using namespace rfm;

namespace {

// Of f(u, v) over [−1, 1]²; `f` returns value, ∂f/∂u and ∂f/∂v.
// `extent(u)` is where it is defined.
template <class Function, class Extent>
auto surveyed(Function f, Extent extent) {
  SignSurvey survey(
      extent,
      [f](double u, double v, double& slope) {
        slope = f(u, v)[2];
        return f(u, v)[0];
      },
      [f](double u, double v) { return f(u, v)[1]; }, 1e-12, 1e-9);
  survey.run({-1, 1});
  return survey;
}

template <class Function>
auto surveyed(Function f) {
  return surveyed(f, [](double) { return Interval(-1, 1); });
}

TEST(SignSurvey, ASaddleHasBothSigns) {
  const auto survey = surveyed([](double u, double v) { return std::array{u * v, v, u}; });
  EXPECT_TRUE(survey.positive());
  EXPECT_TRUE(survey.negative());
}

TEST(SignSurvey, ADoubleLineHasOneSign) {
  const auto survey = surveyed([](double u, double v) {
    const double w = u + 0.7 * v - 0.1;
    return std::array{-w * w, -2 * w, -1.4 * w};
  });
  EXPECT_FALSE(survey.positive());
  EXPECT_TRUE(survey.negative());
  EXPECT_LT(survey.nearest(), 1e-12);
}

TEST(SignSurvey, WhatIsPositiveByRoundingAloneIsZero) {
  const auto survey = surveyed([](double u, double v) {
    const double w = u + 0.7 * v - 0.1;
    return std::array{1e-13 - w * w, -2 * w, -1.4 * w};
  });
  EXPECT_FALSE(survey.positive());
  EXPECT_TRUE(survey.negative());
}

TEST(SignSurvey, TheFunctionIsFollowedToWhereItEnds) {
  // Defined for ±u < 0.37, between two of the sections; positive in the last 1e-5 before it ends.
  for (const double sense : {1.0, -1.0}) {
    const auto survey = surveyed(
        [&](double u, double) {
          return std::array{sense * u - 0.36999, sense, 0.0};
        },
        [&](double u) { return sense * u < 0.37 ? Interval(-1, 1) : Interval(1, -1); });
    EXPECT_TRUE(survey.positive()) << sense;
    EXPECT_TRUE(survey.negative()) << sense;
  }
}

TEST(SignSurvey, AnIslandBetweenSectionsIsFoundByTheExtremaOfSections) {
  // Positive only within 1e-3 of (0.06, 0.3): no section that is looked at first meets it.
  const auto survey = surveyed([](double u, double v) {
    const double a = u - 0.06, b = v - 0.3;
    return std::array{1e-6 - a * a - b * b, -2 * a, -2 * b};
  });
  EXPECT_TRUE(survey.positive());
  EXPECT_TRUE(survey.negative());
}

TEST(SignSurvey, WhatStaysAwayFromZeroTellsHowFar) {
  const auto survey = surveyed([](double u, double v) {
    return std::array{2 + u * u + v * v, 2 * u, 2 * v};
  });
  EXPECT_TRUE(survey.positive());
  EXPECT_FALSE(survey.negative());
  EXPECT_NEAR(survey.nearest(), 2, 1e-12);
}

TEST(SignSurvey, SectionsWithoutTheFunctionSayNothing) {
  const auto survey = surveyed(
      [](double u, double v) {
        return std::array{u * v, v, u};
      },
      [](double) { return Interval(1, -1); });
  EXPECT_FALSE(survey.positive());
  EXPECT_FALSE(survey.negative());
}

}  // namespace
