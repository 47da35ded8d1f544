#include "quadrature/work.hpp"

#include <gmock/gmock.h>

#include "quadrature/cut_cell.hpp"
#include "quadrature/root_isolation.hpp"
#include "tests/quadrature/regions.hpp"

using namespace rfm;
using namespace rfm::test;

namespace {

TEST(WorkLimit, HoldsAsLongAsItLives) {
  const std::int64_t before = last_work;
  {
    const WorkLimit limit(1000);
    EXPECT_EQ(last_work, work_done + 1000);
  }
  EXPECT_EQ(last_work, before);
}

TEST(WorkLimit, WithinAnotherCanOnlyBeNarrower) {
  const WorkLimit outer(1000);
  const std::int64_t end = last_work;
  {
    const WorkLimit wider(5000);
    EXPECT_EQ(last_work, end);
  }
  {
    const WorkLimit narrower(10);
    EXPECT_EQ(last_work, work_done + 10);
  }
  EXPECT_EQ(last_work, end);
}

// The roots of sin(40 t) on [0.01, 3], found by bounds that know nothing but |slope| ≤ 40.
int count_roots(IsolationBudget& budget) {
  int roots = 0;
  isolate_roots(
      [](double t, double& slope) {
        slope = 40 * std::cos(40 * t);
        work_done += 100;
        return std::sin(40 * t);
      },
      [](double, double) { return Interval(-40, 40); }, 0.01, 3, 1e-12, [&](double) { ++roots; },
      budget);
  return roots;
}

TEST(WorkLimit, EndsIsolationsOfRootsAndTheyTell) {
  IsolationBudget spent{.calls = 1'000'000};
  {
    const WorkLimit none(0);
    const std::int64_t before = work_done;
    count_roots(spent);
    EXPECT_LT(work_done - before, 10'000);
  }
  EXPECT_TRUE(spent.exhausted);
}

// Two spheres whose circle of intersection and a wave cross a cell.
CellRule rule_with_budget(std::int64_t budget, std::int64_t& work) {
  const Region region = (region_of(1 - square(x()) - square(y()) - square(z()), 3) &
                         region_of(0.9 - square(x() - 0.3) - square(y()) - square(z()), 3)) -
                        region_of(0.3 + 0.2 * sin(3 * x()) * cos(3 * y()) - z(), 3);
  const RegionEvaluator evaluator(region);
  std::vector<Surface> surfaces;
  std::vector<int> numbers;
  for (int k = 0; k < evaluator.primitive_count(); ++k) {
    surfaces.emplace_back(evaluator.level(k));
    numbers.push_back(k);
  }
  ActiveSet active;
  active.table = TruthTable(evaluator.region().expression(), numbers,
                            std::vector<Truth>(numbers.size(), Truth::unknown));
  for (std::size_t k = 0; k < surfaces.size(); ++k) active.add(surfaces[k], numbers[k]);
  SubdivisionOptions options;
  options.max_work = budget;
  Subdivision subdivision(options);
  CellRule rule;
  const std::int64_t before = work_done;
  add_cell_rule({3, {-1.1, -1.1, -1.1}, {1.1, 1.1, 1.1}}, active, {6}, subdivision, rule);
  work = work_done - before;
  return rule;
}

TEST(WorkLimit, ACellThatEndsItsBudgetSaysWhereAndLosesLittle) {
  std::int64_t enough = 0, little = 0;
  const CellRule whole = rule_with_budget(100'000'000, enough);
  EXPECT_LT(enough, 2'000'000);  // only where surfaces touch anything is left open
  EXPECT_LT(whole.uncertified.measure, 1e-3);
  const double volume = whole.moments.measure.volume;
  double before = INFINITY;
  for (const std::int64_t budget : {20'000, 100'000, 400'000}) {
    const CellRule part = rule_with_budget(budget, little);
    EXPECT_GT(part.uncertified.measure, 100 * whole.uncertified.measure) << budget;
    EXPECT_GT(part.uncertified.boundary, 0) << budget;
    // The budget binds, and more of it leaves less open.
    EXPECT_LT(little, 2 * budget) << budget;
    EXPECT_LT(part.uncertified.measure, before) << budget;
    EXPECT_NEAR(part.moments.measure.volume, volume, part.uncertified.measure) << budget;
    before = part.uncertified.measure;
  }
}

}  // namespace
