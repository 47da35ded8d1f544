#include "core/graded_lines.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rfm {
namespace {

double size_at(double x, const LineGrading& grading) {
  double distance = grading.within;
  for (const double place : grading.toward) distance = std::min(distance, std::abs(x - place));
  const double least = 1 / grading.finer;
  return least + (1 - least) * distance / grading.within;
}

// The ends of the intervals on which the size is linear.
std::vector<double> bends(double low, double high, const LineGrading& grading) {
  std::vector<double> places = grading.toward;
  std::ranges::sort(places);
  std::vector<double> list{low, high};
  for (std::size_t i = 0; i < places.size(); ++i) {
    list.insert(list.end(), {places[i], places[i] - grading.within, places[i] + grading.within});
    if (i > 0) list.push_back(0.5 * (places[i - 1] + places[i]));
  }
  std::erase_if(list, [&](double x) { return !(x >= low && x <= high); });
  std::ranges::sort(list);
  list.erase(std::unique(list.begin(), list.end()), list.end());
  return list;
}

// log(1 + q) / q and its inverse (exp(t) − 1) / t.
double mean_reciprocal(double q) { return std::abs(q) < 1e-12 ? 1 : std::log1p(q) / q; }
double mean_growth(double t) { return std::abs(t) < 1e-12 ? 1 : std::expm1(t) / t; }

}  // namespace

std::vector<double> graded_lines(double low, double high, int cells, const LineGrading& grading) {
  if (!(low < high) || cells < 1) throw InvalidArgument("lines need an interval and a cell");
  if (!(grading.finer >= 1) || !(grading.within > 0))
    throw InvalidArgument("cells are graded by a factor of 1 at least, over a length");
  const std::vector<double> ends = bends(low, high, grading);
  std::vector<double> sizes, xi{0};
  for (const double x : ends) sizes.push_back(size_at(x, grading));
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    xi.push_back(xi.back() +
                 (ends[k + 1] - ends[k]) / sizes[k] * mean_reciprocal(sizes[k + 1] / sizes[k] - 1));
  std::vector<double> lines{low};
  std::size_t k = 0;
  for (int i = 1; i < cells; ++i) {
    const double at = xi.back() * i / cells;
    while (k + 2 < xi.size() && xi[k + 1] <= at) ++k;
    const double slope = (sizes[k + 1] - sizes[k]) / (ends[k + 1] - ends[k]), part = at - xi[k];
    lines.push_back(ends[k] + part * sizes[k] * mean_growth(slope * part));
  }
  lines.push_back(high);
  return lines;
}

std::vector<double> divided_lines(const std::vector<double>& lines, int parts) {
  if (lines.size() < 2 || parts < 1) throw InvalidArgument("there is nothing to divide");
  std::vector<double> result;
  for (std::size_t i = 0; i + 1 < lines.size(); ++i)
    for (int k = 0; k < parts; ++k)
      result.push_back(lines[i] + k * (lines[i + 1] - lines[i]) / parts);
  result.push_back(lines.back());
  return result;
}

}  // namespace rfm
