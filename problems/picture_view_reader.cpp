#include "problems/picture_view_reader.hpp"

namespace rfm {
namespace {

std::optional<Point> direction(const DocumentNode& node, const char* what,
                               const ValueReader& values) {
  const auto point = values.point(node);
  if (!point || *point != Point{0, 0, 0}) return point;
  values.mistakes.add(std::string(what) + " of length 0 has no direction", node.place);
  return {};
}

}  // namespace

void read_view(const DocumentNode& picture_node, const ValueReader& values, Picture& picture) {
  const DocumentNode* view = values.find(picture_node, "view");
  const DocumentNode* cut = values.find(picture_node, "cut");
  if (values.dimension != 3) {
    for (const DocumentNode* node : {view, cut})
      if (node)
        values.mistakes.add(std::string("'") + (node == view ? "view" : "cut") +
                                "' is for pictures of bodies in space: dimension 3",
                            node->place);
    return;
  }
  if (view) picture.view = direction(*view, "a view", values).value_or(picture.view);
  if (!cut) return;
  if (cut->is_scalar()) {
    picture.with_cut = cut->text == "true";
    return;
  }
  if (const DocumentNode* point = values.find(*cut, "point"))
    picture.cut_point = values.point(*point);
  if (const DocumentNode* normal = values.find(*cut, "normal"))
    picture.cut_normal = direction(*normal, "a normal", values);
}

}  // namespace rfm
