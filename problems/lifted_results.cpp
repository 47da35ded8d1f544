#include "problems/lifted_results.hpp"

#include <cctype>
#include <filesystem>

namespace rfm {
namespace {

// A map that can be meant as nothing else; whether it is complete, the table of keys tells.
bool asks_for_result(const DocumentNode& node) {
  if (!node.is_map()) return false;
  const DocumentNode* from = node.find("from");
  return from && from->is_scalar() &&
         (node.find("field") || from->text.ends_with(".yaml") || from->text.ends_with(".yml"));
}

std::string text_of(const DocumentNode& map, const char* key) {
  const DocumentNode* node = map.find(key);
  return node && node->is_scalar() ? node->text : std::string();
}

class Lift {
 public:
  explicit Lift(DocumentNode& root) : root_(root), taken_(words_of(root)) { add_keys(root); }

  void walk(DocumentNode& node) {
    if (asks_for_result(node)) return replace(node);
    for (DocumentNode& item : node.items) walk(item);
    for (DocumentNode::Entry& entry : node.entries) walk(entry.value);
  }

  void finish() {
    if (lifted_.empty()) return;
    DocumentNode* fields = root_.find("fields");
    if (!fields) {
      DocumentNode map;
      map.kind = DocumentNode::Kind::map;
      map.place = lifted_[0].value.place;
      root_.entries.push_back({"fields", map.place, std::move(map)});
      fields = root_.find("fields");
    }
    if (!fields->is_map()) return;  // which is reported
    for (DocumentNode::Entry& entry : lifted_) fields->entries.push_back(std::move(entry));
  }

 private:
  void add_keys(const DocumentNode& node) {
    for (const DocumentNode& item : node.items) add_keys(item);
    for (const DocumentNode::Entry& entry : node.entries) {
      taken_.insert(entry.key);
      add_keys(entry.value);
    }
  }

  void replace(DocumentNode& node) {
    const std::string from = text_of(node, "from"), field = text_of(node, "field");
    std::string name;
    for (const DocumentNode::Entry& known : lifted_)
      if (text_of(known.value, "from") == from && text_of(known.value, "field") == field &&
          known.value.entries.size() == node.entries.size())
        name = known.key;
    if (name.empty()) {
      name = free_name((field.empty() ? "result" : field) + "_of_" +
                       std::filesystem::path(from).stem().string());
      lifted_.push_back({name, node.place, node});
    }
    DocumentNode formula;
    formula.kind = DocumentNode::Kind::scalar;
    formula.place = node.place;
    formula.text = name;
    node = std::move(formula);
  }

  std::string free_name(std::string name) {
    for (char& c : name)
      if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    if (!std::isalpha(static_cast<unsigned char>(name[0]))) name = "result_" + name;
    std::string free = name;
    for (int number = 2; taken_.contains(free); ++number)
      free = name + "_" + std::to_string(number);
    taken_.insert(free);
    return free;
  }

  DocumentNode& root_;
  std::set<std::string, std::less<>> taken_;
  std::vector<DocumentNode::Entry> lifted_;
};

}  // namespace

void lift_results(DocumentNode& root) {
  if (!root.is_map()) return;
  Lift lift(root);
  if (DocumentNode* conditions = root.find("conditions")) lift.walk(*conditions);
  if (DocumentNode* geometry = root.find("geometry"))
    if (DocumentNode* shapes = geometry->find("shapes")) lift.walk(*shapes);
  if (DocumentNode* physics = root.find("physics"); physics && physics->is_map()) {
    if (DocumentNode* own = physics->find("coefficients")) lift.walk(*own);
    if (DocumentNode* materials = physics->find("materials"))
      for (DocumentNode& material : materials->items)
        if (DocumentNode* own = material.find("coefficients")) lift.walk(*own);
  }
  lift.finish();
}

}  // namespace rfm
