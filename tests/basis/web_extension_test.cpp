#include "basis/web_extension.hpp"

#include <gmock/gmock.h>

#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

// Cells whose middle lies in the disk of radius 1, those within 0.75 of it "inside".
struct Disk {
  Grid grid{Box{2, {-1.1, -1.1, 0}, {1.1, 1.1, 0}}, {12, 12, 1}};
  std::vector<std::uint8_t> met, inside;
  Disk() {
    for (int cell = 0; cell < grid.cell_count(); ++cell) {
      const Box box = grid.cell(grid.position(cell));
      const double r =
          std::hypot(0.5 * (box.low[0] + box.high[0]), 0.5 * (box.low[1] + box.high[1]));
      met.push_back(r < 1.1);
      inside.push_back(r < 0.75);
    }
  }
};

double power(int base, int exponent) { return std::pow(base - 6, exponent); }

// The largest deviation of the extension from coefficients x^a y^b of the place, relative.
double deviation(const TensorProductSpace& space, const WebExtension& web, int a, int b) {
  const auto exact = [&](int function) {
    const auto place = space.place(space.spline_of_function(function));
    return power(place[0], a) * power(place[1], b);
  };
  std::vector<double> extended(space.size(), 0.0);
  for (const WebExtension::Entry& entry : web.entries())
    extended[entry.function] += entry.weight * exact(web.inner()[entry.inner]);
  double largest = 0, size = 0;
  for (int function = 0; function < space.size(); ++function) {
    largest = std::max(largest, std::abs(extended[function] - exact(function)));
    size = std::max(size, std::abs(exact(function)));
  }
  return largest / size;
}

TEST(WebExtension, ContinuesPolynomialsUpToTheDegreeAndNoFurther) {
  const Disk disk;
  for (int degree = 1; degree <= 4; ++degree) {
    const TensorProductSpace space(disk.grid, degree, disk.met);
    const WebExtension web(space, disk.inside);
    EXPECT_LT(web.size(), space.size());
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; b <= degree; ++b)
        EXPECT_LT(deviation(space, web, a, b), 1e-12) << degree << " " << a << " " << b;
    EXPECT_GT(deviation(space, web, degree + 1, 0), 1e-3) << degree;
    EXPECT_GT(deviation(space, web, 0, degree + 1), 1e-3) << degree;
  }
}

TEST(WebExtension, KeepsInnerSplinesAsTheyAre) {
  const Disk disk;
  const TensorProductSpace space(disk.grid, 2, disk.met);
  const WebExtension web(space, disk.inside);
  std::vector<int> inner_entries(web.size(), 0);
  for (const WebExtension::Entry& entry : web.entries())
    if (web.inner()[entry.inner] == entry.function) {
      EXPECT_EQ(entry.weight, 1);
      ++inner_entries[entry.inner];
    }
  EXPECT_THAT(inner_entries, testing::Each(1));
}

TEST(WebExtension, TakesInnerFunctionsOfOnesOwnChoice) {
  const Disk disk;
  const TensorProductSpace space(disk.grid, 2, disk.met);
  const WebExtension cells(space, disk.inside);
  std::vector<bool> inner(space.size(), false);
  for (const int function : cells.inner()) inner[function] = true;
  EXPECT_EQ(WebExtension::of_inner(space, inner).inner(), cells.inner());
  inner[cells.inner().front()] = false;
  const WebExtension fewer = WebExtension::of_inner(space, inner);
  EXPECT_EQ(fewer.size(), cells.size() - 1);
  EXPECT_LT(deviation(space, fewer, 2, 2), 1e-12);
  EXPECT_THROW(WebExtension::of_inner(space, {true}), InvalidArgument);
}

// Cells of widths between 0.4 and 1.6 of the mean, different along both axes.
Grid uneven_grid() {
  std::vector<double> lines[2];
  for (int axis = 0; axis < 2; ++axis)
    for (int i = 0; i <= 12; ++i)
      lines[axis].push_back(-1.1 + 2.2 * i / 12 + 0.08 * std::sin((2.1 + axis) * i));
  return Grid::with_lines(lines);
}

// x^a in the splines of an axis: the coefficient of spline j is the mean of the products of a of
// its inner knots.
double blossom_of_power(const Grid& grid, int axis, int degree, int spline, int power) {
  std::vector<double> elementary(power + 1, 0.0);
  elementary[0] = 1;
  double choices = 1;
  for (int i = 1; i <= degree; ++i)
    for (int k = power; k >= 1; --k)
      elementary[k] += grid.knot(axis, spline - degree + i) * elementary[k - 1];
  for (int k = 1; k <= power; ++k) choices *= double(degree + 1 - k) / k;
  return elementary[power] / choices;
}

TEST(WebExtension, ContinuesPolynomialsOnCellsOfDifferentWidths) {
  const Grid grid = uneven_grid();
  Disk disk;
  for (int degree = 1; degree <= 4; ++degree) {
    const TensorProductSpace space(grid, degree, disk.met);
    const WebExtension web(space, disk.inside);
    ASSERT_LT(web.size(), space.size());
    for (int a = 0; a <= degree; ++a)
      for (int b = 0; b <= degree; ++b) {
        const auto exact = [&](int function) {
          const auto place = space.place(space.spline_of_function(function));
          return blossom_of_power(grid, 0, degree, place[0], a) *
                 blossom_of_power(grid, 1, degree, place[1], b);
        };
        std::vector<double> extended(space.size(), 0.0);
        for (const WebExtension::Entry& entry : web.entries())
          extended[entry.function] += entry.weight * exact(web.inner()[entry.inner]);
        for (int function = 0; function < space.size(); ++function)
          EXPECT_NEAR(extended[function], exact(function), 2e-11) << degree << " " << a << " " << b;
      }
  }
}

TEST(WebExtension, IsNothingWhereAllCellsAreInside) {
  const Grid grid(Box{3, {0, 0, 0}, {1, 1, 1}}, {4, 3, 5});
  const TensorProductSpace space(grid, 2);
  const WebExtension web(space, std::vector<std::uint8_t>(grid.cell_count(), 1));
  EXPECT_EQ(web.size(), space.size());
  EXPECT_EQ(web.entries().size(), std::size_t(space.size()));
}

TEST(WebExtension, TakesTheNearestArray) {
  // On a line of 8 cells, cells 2, 3 and 4 inside: splines 2 … 6 of degree 2 are inner ones. Spline
  // 1 goes on from 2, 3, 4, spline 7 from 4, 5, 6.
  const Grid grid(Box{1, {0, 0, 0}, {8, 0, 0}}, {8, 1, 1});
  const TensorProductSpace space(grid, 2);
  const WebExtension web(space, std::vector<std::uint8_t>{0, 0, 1, 1, 1, 0, 0, 0});
  std::vector<std::pair<int, double>> below, above;
  for (const WebExtension::Entry& entry : web.entries()) {
    if (entry.function == 1) below.emplace_back(web.inner()[entry.inner], entry.weight);
    if (entry.function == 7) above.emplace_back(web.inner()[entry.inner], entry.weight);
  }
  using testing::Pair;
  EXPECT_THAT(below, testing::ElementsAre(Pair(2, 3), Pair(3, -3), Pair(4, 1)));
  EXPECT_THAT(above, testing::ElementsAre(Pair(4, 1), Pair(5, -3), Pair(6, 3)));
}

TEST(WebExtension, NeedsAnArrayInside) {
  const Grid grid(Box{1, {0, 0, 0}, {4, 0, 0}}, {4, 1, 1});
  const TensorProductSpace space(grid, 2);
  EXPECT_THROW(WebExtension(space, std::vector<std::uint8_t>{0, 0, 0, 0}), InvalidArgument);
  EXPECT_THROW(WebExtension(space, std::vector<std::uint8_t>{1, 1}), InvalidArgument);
}

}  // namespace
}  // namespace rfm
