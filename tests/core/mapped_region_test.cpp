#include "core/mapped_region.hpp"

#include <gmock/gmock.h>

#include <cmath>
#include <random>

#include "core/error.hpp"
#include "core/primitives.hpp"
#include "core/tape.hpp"

namespace rfm {
namespace {

Region sample() {
  return (box({0, 0}, {2, 1}).named("plate") - circle({0.5, 0.5}, 0.25).named("hole")) |
         half_plane({3, 0}, {1, 1}).named("far");
}

Point image_of(const Point& point, const Similarity& s) {
  const double c = std::cos(s.angle), n = std::sin(s.angle);
  const double dx = point[0] - s.about[0], dy = point[1] - s.about[1];
  return {s.about[0] + s.scale * (c * dx - n * dy) + s.translation[0],
          s.about[1] + s.scale * (n * dx + c * dy) + s.translation[1]};
}

TEST(MappedRegion, APointIsInsideWhereItsImageIs) {
  const Similarity similarity{2.5, 0.7, {0, 0, 1}, {3, -1}, {0.4, 0.2}};
  const Region moved = transformed(sample(), similarity);
  const RegionEvaluator before(sample()), after(moved);
  std::mt19937 generator(4);
  std::uniform_real_distribution<double> uniform(-1, 4);
  int inside = 0;
  for (int i = 0; i < 500; ++i) {
    const Point point{uniform(generator), uniform(generator)};
    inside += before.contains(point);
    EXPECT_EQ(before.contains(point), after.contains(image_of(point, similarity)));
  }
  EXPECT_GT(inside, 50);
  EXPECT_LT(inside, 450);
}

TEST(MappedRegion, FunctionsOfImagesAreDistancesStillAndNamesStay) {
  const Similarity similarity{0.5, -1.2, {0, 0, 1}, {1, 2}, {}};
  const Region original = sample(), moved = transformed(original, similarity);
  ASSERT_EQ(moved.primitives().size(), original.primitives().size());
  for (std::size_t k = 0; k < moved.primitives().size(); ++k) {
    EXPECT_EQ(moved.primitives()[k]->name, original.primitives()[k]->name);
    const Tape before({original.primitives()[k]->function}, {0}, 2);
    const Tape after({moved.primitives()[k]->function}, {0}, 2);
    for (const Point& point : {Point{0.3, 0.4}, Point{-1, 2}})
      EXPECT_NEAR(after.value(image_of(point, similarity)), 0.5 * before.value(point), 1e-14);
  }
}

TEST(MappedRegion, PrimitivesMayBecomeRegionsEverythingOrNothing) {
  const Region replaced = mapped_region(sample(), [](const Primitive& primitive) {
    if (primitive.name == "hole") return MappedPrimitive(false);
    if (primitive.name == "far") return MappedPrimitive(circle({9, 9}, 1) & circle({9.5, 9}, 1));
    return MappedPrimitive(Region(primitive, 2));
  });
  const RegionEvaluator region(replaced);
  EXPECT_TRUE(region.contains(Point{0.5, 0.5}));  // where the hole was
  EXPECT_TRUE(region.contains(Point{9.25, 9}));   // in the lens
  EXPECT_FALSE(region.contains(Point{8.2, 9}));   // in one circle only
  EXPECT_FALSE(region.contains(Point{5, 5}));
  for (const bool everything : {false, true})
    EXPECT_THROW(
        mapped_region(sample(), [&](const Primitive&) { return MappedPrimitive(everything); }),
        InvalidArgument);
}

TEST(MappedRegion, SimilaritiesThatAreNoneAreRefused) {
  EXPECT_THROW(transformed(sample(), {0}), InvalidArgument);
  EXPECT_THROW(transformed(sample(), {-1}), InvalidArgument);
  EXPECT_THROW(transformed(sample(), {1, 0.5, {1, 0, 0}}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
