#include "problems/output/ticks.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <set>

#include "core/error.hpp"

namespace rfm {
namespace {

using testing::ElementsAre;

TEST(Ticks, AreNeighbouringMultiplesOfARoundStepThatCoverTheRange) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 2000; ++trial) {
    const double size = std::pow(10.0, 8 * uniform(random));
    const double low = size * uniform(random), high = low + size * (1.01 + uniform(random));
    const int count = 2 + trial % 9;
    const Ticks ticks = nice_ticks(low, high, count);
    const double power = std::pow(10.0, std::floor(std::log10(ticks.step) + 1e-9));
    const double digit = ticks.step / power;
    EXPECT_TRUE(std::abs(digit - 1) < 1e-9 || std::abs(digit - 2) < 1e-9 ||
                std::abs(digit - 5) < 1e-9)
        << ticks.step;
    const double ideal = (high - low) / count;
    EXPECT_LE(ticks.step, ideal * std::sqrt(2.5) * 1.000001);
    EXPECT_GE(ticks.step, ideal / std::sqrt(2.5) / 1.000001);
    ASSERT_FALSE(ticks.values.empty());
    const double slack = 1e-8 * ticks.step;
    EXPECT_GE(ticks.values.front(), low - slack);
    EXPECT_LT(ticks.values.front(), low + ticks.step + slack);
    EXPECT_LE(ticks.values.back(), high + slack);
    EXPECT_GT(ticks.values.back(), high - ticks.step - slack);
    for (std::size_t i = 0; i < ticks.values.size(); ++i) {
      const double multiple = ticks.values[i] / ticks.step;
      EXPECT_NEAR(multiple, std::round(multiple), 1e-6);
      if (i > 0) {
        EXPECT_NEAR(ticks.values[i] - ticks.values[i - 1], ticks.step, slack);
      }
    }
  }
}

TEST(Ticks, LabelsReadBackAsTheirValuesAndDiffer) {
  std::mt19937 random(11);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (int trial = 0; trial < 500; ++trial) {
    const double size = std::pow(10.0, 9 * uniform(random));
    const double low = 30 * size * uniform(random);
    const Ticks ticks = nice_ticks(low, low + size, 6);
    ASSERT_EQ(ticks.labels.size(), ticks.values.size());
    for (std::size_t i = 0; i < ticks.values.size(); ++i)
      EXPECT_NEAR(std::stod(ticks.labels[i]), ticks.values[i], 1e-6 * ticks.step);
    EXPECT_EQ(std::set<std::string>(ticks.labels.begin(), ticks.labels.end()).size(),
              ticks.labels.size());
  }
}

TEST(Ticks, LabelsAreShort) {
  EXPECT_THAT(nice_ticks(0, 1, 5).labels, ElementsAre("0", "0.2", "0.4", "0.6", "0.8", "1.0"));
  EXPECT_THAT(nice_ticks(-30, 31, 3).labels, ElementsAre("-20", "0", "20"));
  EXPECT_THAT(nice_ticks(290, 350, 3).labels, ElementsAre("300", "320", "340"));
  EXPECT_THAT(nice_ticks(0, 3e-7, 3).labels, ElementsAre("0", "1e-7", "2e-7", "3e-7"));
  EXPECT_THAT(nice_ticks(0, 2.1e11, 4).labels,
              ElementsAre("0", "0.5e11", "1.0e11", "1.5e11", "2.0e11"));
  EXPECT_THAT(nice_ticks(1.0001, 1.0003, 2).labels, ElementsAre("1.0001", "1.0002", "1.0003"));
}

TEST(Ticks, RefuseAnEmptyRange) {
  EXPECT_THROW(nice_ticks(1, 1, 3), InvalidArgument);
  EXPECT_THROW(nice_ticks(0, INFINITY, 3), InvalidArgument);
  EXPECT_THROW(nice_ticks(0, 1, 0), InvalidArgument);
  EXPECT_THROW(decade_ticks(0, 1), InvalidArgument);
}

TEST(Ticks, DecadesArePowersOfTenAndFinerWhereThereAreTooFew) {
  EXPECT_THAT(decade_ticks(3e-4, 2).labels, ElementsAre("0.001", "0.01", "0.1", "1"));
  EXPECT_THAT(decade_ticks(15, 70).labels, ElementsAre("20", "50"));
  EXPECT_THAT(decade_ticks(1e-7, 1e-5).labels, ElementsAre("1e-7", "1e-6", "1e-5"));
}

}  // namespace
}  // namespace rfm
