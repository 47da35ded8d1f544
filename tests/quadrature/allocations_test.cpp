// Memory is taken for parts of the grid, never for points. A program of its own, since it counts
// every allocation.

#include <gmock/gmock.h>
#include <tbb/global_control.h>

#include <atomic>
#include <cstdlib>
#include <new>

#include "quadrature/domain_rule.hpp"
#include "tests/quadrature/standard_regions.hpp"

namespace {
std::atomic<std::int64_t> allocations = 0;

void* allocate(std::size_t size, std::size_t alignment) {
  ++allocations;
  void* memory = std::aligned_alloc(alignment, (size + alignment - 1) / alignment * alignment);
  if (!memory) throw std::bad_alloc();
  return memory;
}
}  // namespace

void* operator new(std::size_t size) { return allocate(size, alignof(std::max_align_t)); }
void* operator new(std::size_t size, std::align_val_t alignment) {
  return allocate(size, static_cast<std::size_t>(alignment));
}
void operator delete(void* memory) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::align_val_t) noexcept { std::free(memory); }
void operator delete(void* memory, std::size_t, std::align_val_t) noexcept { std::free(memory); }

using namespace rfm;
using namespace rfm::test;

namespace {

struct Count {
  double allocations, points, cut_cells;
};

Count count(const StandardRegion& body, int cells, int q) {
  tbb::global_control one_thread(tbb::global_control::max_allowed_parallelism, 1);
  const RegionEvaluator region(body.region);
  QuadratureOptions options;
  options.inside_points = options.cut_points = q;
  const Grid grid(body.box, {cells, cells, cells});
  make_domain_rule(region, grid, options);  // what is made once in a program
  const std::int64_t before = allocations;
  const DomainRule rule = make_domain_rule(region, grid, options);
  return {static_cast<double>(allocations - before),
          static_cast<double>(rule.cut_points().size() + rule.boundary().points.size()),
          static_cast<double>(rule.report().cut_cells)};
}

class Allocations : public testing::TestWithParam<StandardRegion> {};
INSTANTIATE_TEST_SUITE_P(Plane, Allocations, testing::ValuesIn(standard_regions_2d()));
INSTANTIATE_TEST_SUITE_P(Space, Allocations,
                         testing::Values(standard_regions_3d()[0], standard_regions_3d()[1],
                                         standard_regions_3d()[4]));

TEST_P(Allocations, AreAFewPerCellWhateverTheNumberOfPoints) {
  const int cells = GetParam().box.dimension == 2 ? 64 : 16;
  const Count few = count(GetParam(), cells, 3), many = count(GetParam(), cells, 12);
  ASSERT_GT(many.points, 10 * few.points);
  std::printf("%s: %.2f per cut cell with 3 points, %.2f with 12; %.5f per further point\n",
              GetParam().name, few.allocations / few.cut_cells, many.allocations / many.cut_cells,
              (many.allocations - few.allocations) / (many.points - few.points));
  // A thread makes points in memory of its own, which grows by doubling once.
  EXPECT_LT((many.allocations - few.allocations) / (many.points - few.points), 0.005);
  EXPECT_LT(many.allocations / many.cut_cells, 25);
}

TEST(Allocations, AreCounted) {
  const std::int64_t before = allocations;
  delete new int(3);
  EXPECT_EQ(allocations, before + 1);
}

}  // namespace
