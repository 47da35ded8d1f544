#include "problems/physics_reader.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "problems/custom_physics.hpp"
#include "problems/interpolation.hpp"
#include "problems/solution_symbols.hpp"

namespace rfm {
namespace {

constexpr auto coefficient_keys =
    std::to_array<std::string_view>({"diffusivity", "reaction", "source", "conductivity", "density",
                                     "heat_capacity", "modulus", "twist", "tension", "load"});

class PhysicsReader {
 public:
  PhysicsReader(ValueReader& values, ShapeReader& shapes, Problem& problem)
      : values_(values),
        shapes_(shapes),
        problem_(problem),
        physics_(problem.physics),
        scope_(values.scope) {
    define_symbols(scope_, physics_.unknowns, values.dimension);
  }

  void read(const DocumentNode& map) {
    const DocumentNode* type = values_.find(map, "type");
    if (type && type->text == "custom") {
      physics_.type = PhysicsType::custom;
      read_own_coefficients(map);
      physics_.custom = read_custom(map, values_, physics_.unknowns, physics_.coefficients);
      return;
    }
    if (type) physics_.type = type_of(type->text);
    if (const DocumentNode* advection = values_.find(map, "advection")) read_advection(*advection);
    read_coefficients(map, physics_.coefficients);
    const DocumentNode* materials = values_.find(map, "materials");
    if (!materials) return;
    for (const DocumentNode& item : materials->items)
      if (values_.fits(item)) read_material(item);
    check_materials(*materials);
  }

 private:
  // Coefficients of custom physics have names of the user's own, in the formulas and elsewhere.
  void read_own_coefficients(const DocumentNode& map) {
    std::vector<const DocumentNode*> of_materials;
    if (const DocumentNode* materials = values_.find(map, "materials")) {
      for (const DocumentNode& item : materials->items) {
        if (!values_.fits(item)) continue;
        const std::size_t before = physics_.materials.size();
        read_material(item);
        if (physics_.materials.size() > before) of_materials.push_back(&item);
      }
      check_materials(*materials);
    }
    define_own_coefficients(map, values_, physics_.materials, of_materials, physics_.unknowns);
  }

  static PhysicsType type_of(std::string_view word) {
    if (word == "heat") return PhysicsType::heat;
    if (word == "torsion") return PhysicsType::torsion;
    if (word == "membrane") return PhysicsType::membrane;
    if (word == "interpolation") return PhysicsType::interpolation;
    return PhysicsType::poisson;
  }

  std::optional<Field> field(const DocumentNode& node) {
    if (const DocumentNode* list = node.is_map() ? values_.find(node, "interpolate") : nullptr)
      return interpolated(*list);
    if (node.is_map()) return values_.field(node);  // the result of another problem
    if (!values_.fits(node) || !node.is_scalar()) return std::nullopt;
    return values_.guarded<Field>(node, [&] { return to_field(Expression(node.text), scope_); });
  }

  std::optional<Field> interpolated(const DocumentNode& list) {
    for (const DocumentNode& item : list.items) {
      if (!values_.fits(item) || !check_interpolation_entry(item, values_)) return std::nullopt;
      if (const DocumentNode* at = values_.find(item, "at")) mark_shapes(*at);
    }
    return interpolated_coefficient(
        list, {problem_.sets, problem_.shapes, problem_.domain, problem_.dimension},
        problem_.bounds, values_.scope, values_);
  }

  void mark_shapes(const DocumentNode& at) {
    if (problem_.shapes.contains(at.text)) shapes_.mark_used(at.text);
    for (const DocumentNode& name : at.items) mark_shapes(name);
  }

  void read_advection(const DocumentNode& node) {
    if (static_cast<int>(node.items.size()) != values_.dimension)
      return values_.mistakes.add(
          "expected a vector of " + std::to_string(values_.dimension) + " components", node.place);
    for (const DocumentNode& item : node.items)
      physics_.advection.push_back(field(item).value_or(0.0));
    if (std::ranges::all_of(physics_.advection, [](const Field& f) { return f.is_constant(0); }))
      physics_.advection.clear();
  }

  void read_coefficients(const DocumentNode& map,
                         std::map<std::string, PhysicalCoefficient>& coefficients) {
    for (const std::string_view key : coefficient_keys)
      if (const DocumentNode* node = values_.find(map, key))
        if (auto coefficient = read_coefficient(*node))
          coefficients.emplace(key, std::move(*coefficient));
  }

  std::optional<PhysicalCoefficient> read_coefficient(const DocumentNode& node) {
    PhysicalCoefficient coefficient;
    coefficient.place = node.place;
    if (node.is_list()) return read_matrix(node, std::move(coefficient));
    const std::optional<Field> single = field(node);
    if (!single) return std::nullopt;
    coefficient.entries = {*single};
    return coefficient;
  }

  std::optional<PhysicalCoefficient> read_matrix(const DocumentNode& node,
                                                 PhysicalCoefficient coefficient) {
    const auto size = static_cast<std::size_t>(values_.dimension);
    const bool is_square =
        node.items.size() == size && std::ranges::all_of(node.items, [&](const DocumentNode& row) {
          return row.is_list() && row.items.size() == size &&
                 std::ranges::all_of(row.items, &DocumentNode::is_scalar);
        });
    if (!is_square) {
      values_.mistakes.add("expected a matrix of " + std::to_string(size) + " rows of " +
                               std::to_string(size) + " entries",
                           node.place);
      return std::nullopt;
    }
    coefficient.entries.clear();
    coefficient.is_matrix = true;
    for (const DocumentNode& row : node.items)
      for (const DocumentNode& entry : row.items) {
        const auto field =
            values_.guarded<Field>(entry, [&] { return to_field(Expression(entry.text), scope_); });
        coefficient.entries.push_back(field.value_or(1.0));
      }
    return check_symmetry(node, coefficient) ? std::optional(std::move(coefficient)) : std::nullopt;
  }

  // Only equal numbers or equal texts are symmetric: whether two formulas are equal functions
  // cannot be decided.
  bool check_symmetry(const DocumentNode& node, const PhysicalCoefficient& coefficient) {
    const std::size_t size = node.items.size();
    for (std::size_t i = 0; i < size; ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const DocumentNode& entry = node.items[i].items[j];
        const Field& a = coefficient.entries[i * size + j];
        const Field& b = coefficient.entries[j * size + i];
        const bool equal_numbers =
            a.is_constant() && b.is_constant() && a.constant() == b.constant();
        if (equal_numbers || entry.text == node.items[j].items[i].text) continue;
        values_.mistakes.add("the matrix must be symmetric: this entry differs from that of row " +
                                 std::to_string(j + 1) + ", column " + std::to_string(i + 1),
                             entry.place);
        return false;
      }
    return true;
  }

  void read_material(const DocumentNode& node) {
    Material material;
    material.place = node.place;
    const DocumentNode* in = values_.find(node, "in");
    if (in) {
      material.text = in->text;
      material.place = in->place;
      if (in->text != "rest") {
        material.region = shapes_.region(*in);
        if (!material.region) return;
      }
    }
    read_coefficients(node, material.coefficients);
    physics_.materials.push_back(std::move(material));
  }

  void check_materials(const DocumentNode& node) {
    const Material* rest = nullptr;
    for (const Material& material : physics_.materials) {
      if (material.region) continue;
      if (rest)
        values_.mistakes.add("'rest' is given twice", material.place,
                             {{"first given here", rest->place}});
      rest = &material;
    }
    if (physics_.type != PhysicsType::heat || physics_.coefficients.contains("conductivity"))
      return;
    for (const DocumentNode& item : node.items)
      if (values_.fits(item) && !item.find("conductivity"))
        values_.mistakes.add(
            "missing key 'conductivity': neither this material nor physics gives it", item.place);
  }

  ValueReader& values_;
  ShapeReader& shapes_;
  const Problem& problem_;
  Physics& physics_;
  ExpressionScope scope_;  // with the solution as a symbol
};

}  // namespace

void read_physics(const DocumentNode& root, ValueReader& values, ShapeReader& shapes,
                  Problem& problem) {
  if (const DocumentNode* map = values.find(root, "physics"))
    PhysicsReader(values, shapes, problem).read(*map);
}

}  // namespace rfm
