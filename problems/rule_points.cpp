#include "problems/rule_points.hpp"

namespace rfm {
namespace {

constexpr int inside = -1, on_interface = -2;

void append(FieldMesh& mesh, const Point& point, double weight, int piece, const Point& normal) {
  mesh.points.push_back(point);
  mesh.data[0].values.push_back(weight);
  mesh.data[1].values.push_back(piece);
  mesh.data[2].values.insert(mesh.data[2].values.end(), normal.begin(), normal.end());
}

}  // namespace

FieldMesh rule_points(const DomainRule& rule) {
  FieldMesh mesh;
  mesh.data = {{"weight", 1, {}}, {"piece", 1, {}}, {"normal", 3, {}}};
  VolumePoints volume;
  for (const int cell : rule.inside_cells()) rule.add_inside_points(cell, volume);
  volume.append(rule.cut_points());
  for (int i = 0; i < volume.size(); ++i)
    append(mesh, volume.point(i), volume.weights[i], inside, Point{});
  const SurfacePoints& boundary = rule.boundary().points;
  for (int i = 0; i < boundary.size(); ++i)
    append(mesh, boundary.point(i), boundary.weights[i], boundary.numbers[i], boundary.normal(i));
  const SurfacePoints& interfaces = rule.interfaces().points;
  for (int i = 0; i < interfaces.size(); ++i)
    append(mesh, interfaces.point(i), interfaces.weights[i], on_interface, interfaces.normal(i));
  return mesh;
}

}  // namespace rfm
