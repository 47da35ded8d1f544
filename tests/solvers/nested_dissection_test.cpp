#include "solvers/nested_dissection.hpp"

#include <gmock/gmock.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace rfm {
namespace {

// Number of entries of the Cholesky factor for an order of elimination, by elimination itself.
std::int64_t fill(const std::vector<std::set<int>>& graph, const std::vector<std::int64_t>& order) {
  std::vector<int> step(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) step[order[i]] = static_cast<int>(i);
  std::vector<std::set<int>> columns(order.size());  // rows below the diagonal, by step
  for (std::size_t v = 0; v < graph.size(); ++v)
    for (const int w : graph[v])
      if (step[w] > step[v]) columns[step[v]].insert(step[w]);
  std::int64_t count = 0;
  for (std::set<int>& column : columns) {
    count += 1 + static_cast<std::int64_t>(column.size());
    if (column.empty()) continue;
    const int parent = *column.begin();
    columns[parent].insert(std::next(column.begin()), column.end());
  }
  return count;
}

std::vector<std::set<int>> interactions(const TensorProductSpace& space) {
  std::vector<std::set<int>> graph(space.size());
  std::vector<int> functions(space.functions_per_cell());
  for (int cell = 0; cell < space.grid().cell_count(); ++cell) {
    space.cell_functions(cell, functions);
    for (const int a : functions)
      for (const int b : functions)
        if (a != b) graph[a].insert(b);
  }
  return graph;
}

TEST(NestedDissection, OrdersEveryUnknownOnce) {
  const Grid grid({3, {0, 0, 0}, {1, 1, 1}}, {9, 7, 5});
  std::vector<std::uint8_t> cells(grid.cell_count());
  for (std::size_t cell = 0; cell < cells.size(); ++cell) cells[cell] = cell % 7 < 3;
  const std::vector<TensorProductSpace> spaces{{grid, 2, cells}, {grid, 3, cells}};
  std::vector<std::int64_t> order = nested_dissection(spaces);
  std::sort(order.begin(), order.end());
  std::vector<std::int64_t> all(spaces[0].size() + spaces[1].size());
  std::iota(all.begin(), all.end(), 0);
  EXPECT_EQ(order, all);
  EXPECT_TRUE(nested_dissection({}).empty());
}

TEST(NestedDissection, ReducesTheFillOfALargePlaneGrid) {
  const Grid grid({2, {0, 0}, {1, 1}}, {60, 60, 1});
  const TensorProductSpace space(grid, 1);
  const std::vector<std::set<int>> graph = interactions(space);
  std::vector<std::int64_t> natural(space.size());
  std::iota(natural.begin(), natural.end(), 0);
  const std::int64_t band = fill(graph, natural);
  const std::int64_t dissected = fill(graph, nested_dissection(std::span(&space, 1)));
  // A band of width n + 1 has n² (n + 2) entries nearly; dissection at most 31/4 n² log₂ n
  // (George).
  const double n = 61;
  EXPECT_NEAR(double(band), n * n * (n + 2), 0.03 * n * n * n);
  EXPECT_LT(double(dissected), 31. / 4 * n * n * std::log2(n));
}

TEST(NestedDissection, SeparatesFunctionsThatDoNotInteract) {
  // Along a line everything before the separator is eliminated in two parts that do not touch.
  const Grid grid({1, {0}, {1}}, {400, 1, 1});
  const TensorProductSpace space(grid, 3);
  const std::vector<std::int64_t> order = nested_dissection(std::span(&space, 1));
  const std::set<std::int64_t> separator(order.end() - 3, order.end());
  EXPECT_EQ(*separator.rbegin() - *separator.begin(), 2);  // three neighbours, near the middle
  EXPECT_NEAR(double(*separator.begin()), 200, 3);
}

}  // namespace
}  // namespace rfm
