#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>

#include "core/boolean_text.hpp"
#include "core/outline.hpp"
#include "core/region.hpp"
#include "core/separators.hpp"
#include "problems/set_reader.hpp"
#include "problems/value_reader.hpp"

namespace rfm {

/// What stands for a shape that has a mistake.
Region stand_in_shape(int dimension);

/// Reads `geometry.shapes` and the domain. Shapes are built when they are first named, since they
/// may name each other in any order: `combine`, and `omega(name)` in formulas. Gives `omega` its
/// meaning, for shapes and sets, in the scope of `values`.
class ShapeReader {
 public:
  /// All must outlive the reader.
  /// `list` is the map under `geometry`: `shapes`, or `profiles` (plane shapes without a domain).
  ShapeReader(const DocumentNode& root, ValueReader& values, SetReader& sets,
              std::string list = "shapes");
  ~ShapeReader();

  /// Builds what has not been named yet, and the domain.
  void read_all();
  /// The shape that a text names. Throws `InputError` if there is none, or if it contains itself.
  Region shape(const BooleanText::Name& name);
  /// A Boolean expression of shapes; their mistakes are reported.
  std::optional<Region> region(const DocumentNode& node);
  /// To be called for shapes that are named other than in texts given to `region`.
  void mark_used(const std::string& shape);
  /// Shapes that neither the domain nor a used shape nor `mark_used` names are mistakes. In a
  /// document with other mistakes only those that no text of it names.
  void report_unused();

  /// Shapes that were built; those with mistakes are stand-ins of the same kind.
  const std::map<std::string, Region>& shapes() const { return built_; }
  /// Nothing if the domain has a mistake.
  const std::optional<Region>& domain() const { return domain_; }
  /// A set of this name, and which there are.
  const ThinSet* set(const std::string& name) const;
  std::vector<std::string> set_names() const { return sets_.names(); }
  /// A side that is no primitive of its own: part of one, or several.
  const OutlineSide* side(const std::string& name) const;
  /// Shapes given by the sets that their boundaries are made of.
  const std::map<std::string, DescribedSolid>& described() const { return described_; }
  /// `omega(name)` without this reader, for the problem.
  ExpressionFunction final_omega() const;

 private:
  const Region& built(const std::string& name, std::size_t offset);
  Region build(const std::string& name, const DocumentNode& node);
  Region build_kind(const std::string& kind, const DocumentNode& node);
  struct Profiles;
  void read_profiles();
  void report_unused_profiles();
  Region derived_shape(const std::string& kind, const DocumentNode& node);
  /// The plane region that the `profile` of a shape names.
  std::optional<Region> profile(const DocumentNode& node);
  Region build_extrusion(const DocumentNode& node);
  Region build_revolution(const DocumentNode& node);
  Region build_transform(const DocumentNode& node);
  Region build_quadric(const DocumentNode& node);
  Region build_enclosed(const DocumentNode& list);
  void add_sides(const std::vector<OutlineSide>& sides);
  /// Whether one of the shapes whose functions a formula names is the formal complement of another.
  void check_complements(const DocumentNode& formula);
  ExpressionFunction omega();
  /// The function of `plate`, `plate.left` or `domain`, given the shape or the domain.
  static Field omega_of(const Region& region, const std::string& name,
                        const std::map<std::string, Field>& distances);

  const DocumentNode& root_;
  ValueReader& values_;
  SetReader& sets_;
  std::string list_;
  std::shared_ptr<Profiles> profiles_;
  std::map<std::string, const DocumentNode*> nodes_;
  std::map<std::string, Place> key_places_;
  std::map<std::string, Region> built_;
  std::map<std::string, OutlineSide> sides_;
  std::map<std::string, DescribedSolid> described_;
  std::map<std::string, Field> distances_;  ///< of shapes as a whole, where `exact` is set
  std::vector<std::string> building_;
  std::map<std::string, std::set<std::string>> names_in_;  ///< "": named outside of shapes
  /// Shapes whose functions the formula of a shape names.
  std::map<std::string, std::set<std::string>> functions_in_;
  std::optional<Region> domain_;
};

}  // namespace rfm
