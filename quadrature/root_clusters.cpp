#include "quadrature/root_clusters.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rfm {
namespace {

// Surfaces that are one as far as neighbouring lines tell.
struct Cluster {
  int count = 0;
  std::array<int, ActiveSet::capacity> surfaces;
  std::array<double, ActiveSet::capacity> positions;

  void add(int surface, double position) {
    surfaces[count] = surface;
    positions[count++] = position;
  }
};

// Whether something of a length that is more than rounding lies inside between the roots of a
// cluster, although nothing changes across it.
bool loses_part(const ActiveSet& active, SurfaceSigns signs, const Cluster& cluster,
                double rounding) {
  const bool inside = active.inside(signs);
  SurfaceSigns after = signs;
  for (int i = 0; i < cluster.count; ++i) after ^= 1u << cluster.surfaces[i];
  if (active.inside(after) != inside) return false;
  for (int i = 0; i + 1 < cluster.count; ++i) {
    signs ^= 1u << cluster.surfaces[i];
    if (active.inside(signs) != inside &&
        cluster.positions[i + 1] - cluster.positions[i] > rounding)
      return true;
  }
  return false;
}

// Divides the roots from `first` to `last`, which are in one place, into clusters in the order in
// which neighbouring lines meet them; `signs` are those below. Sides of turned boxes are no pieces
// of the boundary, and stay with what touches them.
void divide_roots(const ActiveSet& active, const LineSegment& line, SurfaceSigns signs, int first,
                  int last, LineRoots& roots) {
  const double near = same_height(line);
  std::array<Cluster, ActiveSet::capacity> clusters;
  int count = 0;
  for (int i = first; i < last; ++i) {
    const int surface = roots.surfaces[i];
    if (active.numbers[surface] == ActiveSet::no_piece) return;
    int place = 0;
    bool is_new = true;
    for (; place < count; ++place) {
      const double above = line.neighbours->height_over(surface, clusters[place].surfaces[0], line);
      is_new = std::fabs(above) > near;
      if (!(above > near)) break;
    }
    if (place == count || is_new) {
      for (int k = count++; k > place; --k) clusters[k] = clusters[k - 1];
      clusters[place].count = 0;
    }
    clusters[place].add(surface, roots.positions[i]);
  }
  const double size =
      std::max({std::fabs(line.low), std::fabs(line.high), std::fabs(line.through[0]),
                std::fabs(line.through[1]), std::fabs(line.through[2])});
  const double rounding = 16 * std::numeric_limits<double>::epsilon() * size;
  double position = roots.positions[first];
  int next = first;
  for (int k = 0; k < count; ++k) {
    const Cluster& cluster = clusters[k];
    if (loses_part(active, signs, cluster, rounding)) line.neighbours->note_loss();
    position = std::max(position, cluster.positions[0]);
    for (int i = 0; i < cluster.count; ++i, ++next) {
      roots.surfaces[next] = cluster.surfaces[i];
      roots.positions[next] = position;
      signs ^= 1u << cluster.surfaces[i];
      if (i == 0) roots.joined &= ~(1u << next);
    }
  }
}

}  // namespace

void form_clusters(const ActiveSet& active, const LineSegment& line, LineRoots& roots) {
  const double near = same_height(line);
  SurfaceSigns signs = roots.start;
  for (int first = 0; first < roots.count;) {
    int last = first + 1;
    for (; last < roots.count && roots.positions[last] - roots.positions[first] <= near; ++last)
      roots.joined |= 1u << last;
    if (last > first + 1 && line.neighbours) divide_roots(active, line, signs, first, last, roots);
    for (; first < last; ++first) signs ^= 1u << roots.surfaces[first];
  }
}

}  // namespace rfm
