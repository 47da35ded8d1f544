#include "problems/rule_points.hpp"

#include <algorithm>

#include "quadrature/divergence_defects.hpp"

namespace rfm {
namespace {

constexpr int inside = -1, on_interface = -2;

// Appends points cell by cell, each with what the report says of its cell.
class PointMesh {
 public:
  explicit PointMesh(const DomainRule& rule)
      : cells_(rule.report().cells), defects_(divergence_defects(rule)) {
    mesh_.data = {{"weight", 1, {}},           {"piece", 1, {}},
                  {"normal", 3, {}},           {"cell", 1, {}},
                  {"order_difference", 1, {}}, {"divergence_defect", 1, {}},
                  {"uncertified", 1, {}}};
  }

  void begin_cell(int cell) {
    cell_ = cell;
    report_ = {};
    defect_ = 0;
    const auto found = std::ranges::lower_bound(cells_, cell, {}, &CellReport::cell);
    if (found == cells_.end() || found->cell != cell) return;
    report_ = *found;
    defect_ = defects_[found - cells_.begin()];
  }

  void add(const Point& point, double weight, int piece, const Point& normal) {
    mesh_.points.push_back(point);
    const double difference =
        piece == inside ? report_.order_difference.volume : report_.order_difference.boundary;
    mesh_.data[0].values.push_back(weight);
    mesh_.data[1].values.push_back(piece);
    mesh_.data[2].values.insert(mesh_.data[2].values.end(), normal.begin(), normal.end());
    mesh_.data[3].values.push_back(cell_);
    mesh_.data[4].values.push_back(difference);
    mesh_.data[5].values.push_back(defect_);
    mesh_.data[6].values.push_back(report_.uncertified.measure);
  }

  FieldMesh take() { return std::move(mesh_); }

 private:
  const std::vector<CellReport>& cells_;
  const std::vector<double> defects_;
  FieldMesh mesh_;
  int cell_ = 0;
  CellReport report_;
  double defect_ = 0;
};

void add_volume(PointMesh& mesh, const VolumePoints& points, PointRange range) {
  for (int i = range.begin; i < range.end; ++i)
    mesh.add(points.point(i), points.weights[i], inside, Point{});
}

void add_surface(PointMesh& mesh, const SurfaceRule& rule, bool are_interfaces) {
  const SurfacePoints& points = rule.points;
  for (std::size_t k = 0; k < rule.cells.size(); ++k) {
    mesh.begin_cell(rule.cells[k]);
    const PointRange range = rule.range(static_cast<int>(k));
    for (int i = range.begin; i < range.end; ++i)
      mesh.add(points.point(i), points.weights[i],
               are_interfaces ? on_interface : points.numbers[i], points.normal(i));
  }
}

}  // namespace

FieldMesh rule_points(const DomainRule& rule) {
  PointMesh mesh(rule);
  for (const int cell : rule.inside_cells()) {
    VolumePoints points;
    rule.add_inside_points(cell, points);
    mesh.begin_cell(cell);
    add_volume(mesh, points, {0, points.size()});
  }
  for (std::size_t k = 0; k < rule.cut_cells().size(); ++k) {
    mesh.begin_cell(rule.cut_cells()[k]);
    add_volume(mesh, rule.cut_points(), rule.cut_range(static_cast<int>(k)));
  }
  add_surface(mesh, rule.boundary(), false);
  add_surface(mesh, rule.interfaces(), true);
  return mesh.take();
}

}  // namespace rfm
