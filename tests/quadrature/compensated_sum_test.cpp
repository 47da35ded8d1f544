#include "quadrature/compensated_sum.hpp"

#include <gmock/gmock.h>

using namespace rfm;

namespace {

TEST(CompensatedSum, KeepsWhatAPlainSumLoses) {
  CompensatedSum sum;
  sum.add(1);
  sum.add(1e100);
  sum.add(1);
  sum.add(-1e100);
  EXPECT_EQ(sum.value(), 2);
}

TEST(CompensatedSum, OfSumsIsThatOfAllTerms) {
  CompensatedSum first, second;
  first.add(1);
  first.add(1e100);
  second.add(1);
  second.add(-1e100);
  first.add(second);
  EXPECT_EQ(first.value(), 2);
}

TEST(CompensatedSum, DoesNotDriftWithTheNumberOfTerms) {
  CompensatedSum sum;
  double plain = 0;
  for (int i = 0; i < 10'000'000; ++i) {
    sum.add(0.1);
    plain += 0.1;
  }
  EXPECT_EQ(sum.value(), 1e6);
  EXPECT_NE(plain, 1e6);
}

}  // namespace
