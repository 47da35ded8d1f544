#include "problems/combine_reader.hpp"

#include <algorithm>

#include "core/boolean_text.hpp"
#include "core/nearest_name.hpp"

namespace rfm {
namespace {

class CombineReader {
 public:
  CombineReader(const DocumentNode& combine, ValueReader& values,
                const std::optional<Region>& domain)
      : combine_(combine), values_(values), domain_(domain) {}

  WeightOptions read() {
    WeightOptions options;
    if (const DocumentNode* rule = values_.find(combine_, "rule")) options.rule = this->rule(*rule);
    if (const DocumentNode* map = values_.find(combine_, "saturate")) {
      Saturation saturation;
      saturation.alpha = number(*map, "alpha", saturation.alpha);
      saturation.beta = number(*map, "beta", saturation.beta);
      options.saturation = saturation;
    }
    if (const DocumentNode* cap = values_.find(combine_, "cap")) options.cap = values_.field(*cap);
    if (const DocumentNode* scales = values_.find(combine_, "corner_scales"))
      read_scales(*scales, options);
    return options;
  }

 private:
  double number(const DocumentNode& map, const char* key, double otherwise) {
    const DocumentNode* node = values_.find(map, key);
    return node ? values_.number(*node).value_or(otherwise) : otherwise;
  }

  int integer(const char* key, int otherwise) {
    const DocumentNode* node = values_.find(combine_, key);
    return node ? values_.integer(*node).value_or(otherwise) : otherwise;
  }

  CombineRule rule(const DocumentNode& node) {
    const std::string& name = node.text;
    if (name == "R0") return RAlpha{0};
    if (name == "R1") return R1{};
    if (name == "Ralpha") return RAlpha{number(combine_, "alpha", 0)};
    if (name == "Rp") return Rp{even_exponent()};
    if (name == "R0m") return RAlphaM{0, integer("m", 1)};
    if (name == "product") return ProductRule{};
    if (name == "plateau") return PlateauRule{number(combine_, "width", 1), integer("power", 3)};
    return AutomaticRule{};
  }

  int even_exponent() {
    const int p = integer("p", 2);
    if (p % 2 == 0) return p;
    values_.mistakes.add("expected an even whole number for 'p' but found " + std::to_string(p),
                         combine_.find("p")->place);
    return 2;
  }

  void read_scales(const DocumentNode& map, WeightOptions& options) {
    for (const DocumentNode::Entry& entry : map.entries) {
      const double scale = values_.number(entry.value).value_or(1);
      DocumentNode key;
      key.text = entry.key;
      key.place = entry.key_place;
      values_.guarded<bool>(key, [&] {
        const std::vector<BooleanText::Name> names = BooleanText(key.text).names();
        const bool is_corner = names.size() == 2 && key.text.find('&') != std::string::npos;
        if (names.size() > 2 || (names.size() == 2 && !is_corner) ||
            key.text.find('!') != std::string::npos)
          throw InputError("expected the name of a piece, or of two as 'a & b'", 0,
                           key.text.size());
        for (const BooleanText::Name& name : names) require_piece(name);
        if (is_corner)
          options.corner_scales.push_back({names[0].name, names[1].name, scale});
        else
          options.piece_scales.push_back({names[0].name, scale});
        return true;
      });
    }
  }

  void require_piece(const BooleanText::Name& name) {
    if (!domain_) return;
    std::vector<std::string> known;
    for (const auto& primitive : domain_->primitives()) {
      if (primitive->name == name.name || primitive->name.starts_with(name.name + ".")) return;
      known.push_back(primitive->name);
    }
    throw InputError("the domain has no piece '" + name.name + "'" + did_you_mean(name.name, known),
                     name.offset, name.name.size());
  }

  const DocumentNode& combine_;
  ValueReader& values_;
  const std::optional<Region>& domain_;
};

}  // namespace

WeightOptions read_combine(const DocumentNode& combine, ValueReader& values,
                           const std::optional<Region>& domain) {
  return CombineReader(combine, values, domain).read();
}

}  // namespace rfm
