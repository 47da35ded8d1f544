#include "core/diagnosis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <vector>

#include "core/spline_field.hpp"

using namespace rfm;

namespace {

const Field x = x_coordinate(), y = y_coordinate();

TEST(Diagnosis, NothingIsSaidOfFiniteValues) { EXPECT_EQ(diagnose(1 / x, {2, 0}, 2), ""); }

TEST(Diagnosis, InnermostFailingOperationIsNamedWithItsArgumentsAndFormula) {
  EXPECT_EQ(diagnose(exp(1 + sqrt(x - 1)) * y, {0.75, 3}, 2), "sqrt(-0.25) in sqrt(x - 1)");
  EXPECT_EQ(diagnose(y + 1 / (x - 2), {2, 0}, 2), "1 / 0 in 1/(x - 2)");
  EXPECT_EQ(diagnose(log(x) * 0.5, {0, 0}, 2), "log(0) in log(x)");
  EXPECT_EQ(diagnose(pow(x, -2.0), {0, 0}, 2), "0^-2 in x^-2");
  EXPECT_EQ(diagnose(pow(x - 1, 0.5), {0.5, 0}, 2), "-0.5^0.5 in (x - 1)^0.5");
  EXPECT_EQ(diagnose(exp(x * 1000), {1, 0}, 2), "exp(1000) in exp(x*1000)");
  EXPECT_EQ(diagnose(asin(x) + y, {1.5, 0}, 2), "asin(1.5) in asin(x)");
}

TEST(Diagnosis, BranchesNotTakenAreNotBlamed) {
  const Field inside = apply(Operation::less, {x, 1.0});
  EXPECT_EQ(diagnose(select(inside, log(x), sqrt(x - 3)), {-0.5, 0}, 2), "log(-0.5) in log(x)");
  EXPECT_EQ(diagnose(select(inside, log(x), sqrt(x - 3)), {2, 0}, 2), "sqrt(-1) in sqrt(x - 3)");
  EXPECT_EQ(diagnose(select(inside, x, sqrt(x - 3)), {-0.5, 0}, 2), "");
}

TEST(Diagnosis, InfinityIsNotBlamedForWhatAnotherArgumentFailsOf) {
  const Field infinite = 1 / x, failing = sqrt(y);
  for (const Field& f : {min(infinite, failing), max(infinite, failing), infinite + failing,
                         apply(Operation::atan2, {infinite, failing})})
    EXPECT_EQ(diagnose(f, {0, -1}, 2), "sqrt(-1) in sqrt(y)");
  EXPECT_EQ(diagnose(infinite - infinite * y, {0, 1}, 2), "1 / 0 in 1/x");
}

TEST(Diagnosis, ComparisonsWithWhatIsNotANumberDoNotHideIt) {
  const Field root = sqrt(x);
  const Field below = apply(Operation::less, {root, 1.0});
  for (const Field& f :
       {below, select(below, 1.0, y), step(root), sign(root), min(1.0, root), min(root, 1.0),
        max(1.0, root), max(root, 1.0), apply(Operation::equal, {root, 1.0}),
        apply(Operation::less_equal, {1.0, root}), 1 - step(root)})
    EXPECT_EQ(diagnose(f, {-4, 0.5}, 2), "sqrt(-4) in sqrt(x)");
}

TEST(Diagnosis, InfinityIsANumberOfWhichTheLimitIsTaken) {
  // exp(−1/x²) is 0 at 0, and smooth: an infinite part is no mistake, an infinite result is.
  EXPECT_EQ(diagnose(exp(-1 / (x * x)), {0, 0}, 2), "");
  for (const Field& f : {min(1, 1 / x), tanh(1 / x), atan(1 / x), 1 / (1 / x), step(-log(x))})
    EXPECT_EQ(diagnose(f, {0, 0}, 2), "");
  EXPECT_EQ(diagnose(max(1, 1 / x), {0, 0}, 2), "1 / 0 in 1/x");
  EXPECT_EQ(diagnose(0 * (1 / x), {0, 0}, 2), "1 / 0 in 1/x");
  EXPECT_EQ(diagnose(1 / x - 1 / x, {0, 0}, 2), "1 / 0 in 1/x");
  EXPECT_EQ(diagnose(0 / x, {0, 0}, 2), "0 / 0 in 0/x");
}

TEST(Diagnosis, DerivativesAreLookedForWhereTheyAreUsed) {
  EXPECT_EQ(diagnose(1 + partial(log(x), 0), {1e-320, 0}, 2),
            "a derivative of log(9.99989e-321) in log(x)");
  EXPECT_EQ(diagnose(partial(sqrt(x - 1), 0), {0.75, 0}, 2), "sqrt(-0.25) in sqrt(x - 1)");
  // The derivative of log is used elsewhere, but not the one that fails here.
  const Field shared = log(x);
  EXPECT_EQ(diagnose(select(step(y), shared + 1 / y, partial(shared, 0)), {1e-320, 0}, 2),
            "1 / 0 in 1/y");
}

TEST(Diagnosis, ParametersHaveTheirValues) {
  const Field f = sqrt(parameter(1) - x);
  const double values[] = {0.0, 2.0};
  EXPECT_EQ(diagnose(f, {1, 0}, 2, 0, values), "");
  EXPECT_EQ(diagnose(f, {3, 0}, 2, 0, values), "sqrt(-1) in sqrt([parameter 1] - x)");
  EXPECT_EQ(diagnose(f, {3, 0}, 2), "parameter number 1 has no finite value");
  EXPECT_EQ(diagnose(1 / time_coordinate(), {}, 2, 0), "1 / 0 in 1/t");
  EXPECT_EQ(diagnose(1 / time_coordinate(), {}, 2, 2), "");
}

TEST(Diagnosis, SourcesSayWhereTheyAreValid) {
  const Grid grid({2, {0, -1}, {2, 1}}, {2, 2, 1});
  const Field sampled = field(std::make_shared<SplineField>(grid, 1, std::vector<double>(9, 1.0)));
  EXPECT_EQ(diagnose(2 * sampled, {1, 0.5}, 2), "");
  EXPECT_EQ(diagnose(2 * sampled, {2.5, 0.5}, 2),
            "a sampled field outside its region [0, 2] x [-1, 1]");
}

TEST(Diagnosis, LongFormulasAreCutOff) {
  Field sum = x;
  for (int i = 0; i < 100; ++i) sum = sum + sin(Field(i) * y);
  const std::string text = diagnose(1 + log(sum), {-1000, 0}, 2);
  EXPECT_TRUE(text.starts_with("log(-1000) in log(x + ")) << text;
  EXPECT_LT(text.size(), 100u);
  EXPECT_TRUE(text.ends_with("…"));
}

// Not a number, and counts how often it was asked for.
class Counted : public FieldSource {
 public:
  void evaluate(const std::array<const double*, 3>&, int count, int, int, double* jets,
                int) const override {
    ++evaluations;
    std::fill_n(jets, count, std::nan(""));
  }
  FunctionBounds bounds(const Box&) const override { return {Interval::entire(), {}, false}; }
  std::vector<double> breakpoints(int) const override { return {}; }
  Box valid() const override { return {2, {-9, -9, 0}, {9, 9, 0}}; }

  mutable int evaluations = 0;
};

TEST(Diagnosis, EveryNodeIsEvaluatedOnceHoweverOftenItIsShared) {
  const auto source = std::make_shared<Counted>();
  Field shared = field(source);
  diagnose(sin(shared) + y, {1, 0}, 2);
  const int of_one_use = source->evaluations;
  source->evaluations = 0;
  for (int i = 0; i < 60; ++i) shared = sin(shared) * (shared + y);  // 2^60 paths
  EXPECT_NE(diagnose(shared, {1, 0}, 2), "");
  EXPECT_EQ(source->evaluations, of_one_use);
}

TEST(Diagnosis, DeepGraphsCostNoStack) {
  Field deep = sqrt(x);
  for (int i = 0; i < 100'000; ++i) deep = sin(deep) + y;
  EXPECT_EQ(diagnose(deep, {-1, 0}, 2), "sqrt(-1) in sqrt(x)");
}

TEST(PointText, ShowsTenDigits) {
  EXPECT_EQ(point_text({0.5, -1, 7}, 2), "(0.5, -1)");
  EXPECT_EQ(point_text({1.0 / 3, 0, 1e-12}, 3), "(0.3333333333, 0, 1e-12)");
}

}  // namespace
