#pragma once

#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rfm {

/// What may stand as the value of a key; a key may take several (`number | list`).
enum ValueType : unsigned {
  number_value = 1u << 0,      ///< a number, or an expression of parameters
  integer_value = 1u << 1,     ///< the same, a whole number
  boolean_value = 1u << 2,     ///< true or false
  text_value = 1u << 3,        ///< any text
  word_value = 1u << 4,        ///< one of the words of the table
  name_value = 1u << 5,        ///< the name of a shape, side, region or result
  expression_value = 1u << 6,  ///< a formula in x, y, z, t, parameters and fields
  result_value = 1u << 7,      ///< a formula that may also name results, as grad(u)
  shapes_value = 1u << 8,      ///< a Boolean expression of shapes
  file_value = 1u << 9,        ///< the name of a file
  vector_value = 1u << 10,     ///< a list of numbers, one for each dimension
  numbers_value = 1u << 11,    ///< a list of numbers
  matrix_value = 1u << 12,     ///< a list of rows, each a list of formulas
  list_value = 1u << 13,       ///< a list whose items have rows of their own: `path[]`
  map_value = 1u << 14,        ///< a map with the keys of the table
  named_map_value = 1u << 15,  ///< a map whose keys are names of the user's choice: `path.*`
  functions_value = 1u << 16,  ///< a map of definitions `f(a, b): formula`
};

struct Range {
  double low = -std::numeric_limits<double>::infinity();
  double high = std::numeric_limits<double>::infinity();
  bool low_excluded = false;

  bool contains(double value) const;
  /// "greater than 0", "from 1 to 3"; empty if there is no limit.
  std::string text() const;
};

/// Whether a key must be there, and what it is if not.
struct Presence {
  enum class Kind { required, optional, alternative };
  Kind kind = Kind::optional;
  /// Value of a key that is left out, as YAML; of alternatives (exactly one must be given), the one
  /// that is taken when none is.
  std::string_view standard = {};
  /// The key is not needed, and gets no default, where this sibling is given. Of an alternative:
  /// it may stand beside this one.
  std::string_view unless = {};
};

/// Whether this program does what a key asks for. `later` keys are refused as "not supported yet".
enum class Status { works, later };

/// One row of the table of keys. Everything that depends on what keys there are reads the table:
/// the checks of the reader with their suggestions, the defaults, `explain` and the JSON Schema.
struct SchemaRow {
  /// `geometry.shapes.*.circle.radius`: `*` is a name of the user's choice, `[]` an item of a list,
  /// and `physics.type=heat` a word that the key may have.
  std::string_view path;
  unsigned types;
  Presence presence;
  std::string_view doc;
  Status status = Status::works;
  Range range = {};
  /// Words, one of which must be active for the row to apply: the `type` beside it, an alternative
  /// that is present beside it, or the dimension as `1D 2D 3D`. Empty: always.
  std::string_view when = {};
};

/// The table, by subject.
std::span<const SchemaRow> document_rows();
std::span<const SchemaRow> shape_rows();
std::span<const SchemaRow> geometry_rows();
std::span<const SchemaRow> condition_rows();
std::span<const SchemaRow> physics_rows();
std::span<const SchemaRow> run_rows();

/// The table as a tree. `keys` holds the rows of the keys of a map, several of one name where they
/// apply under different conditions; `words` those of a word.
struct SchemaKey {
  std::string name;
  std::string path;
  unsigned types = map_value;
  Presence presence = {};
  std::string doc;
  Status status = Status::works;
  Range range = {};
  std::vector<std::string> when;
  std::vector<SchemaKey> keys;
  std::vector<SchemaKey> words;
  std::vector<SchemaKey> items;  ///< of a list: one row
  std::vector<SchemaKey> named;  ///< of a map of names: one row

  bool takes(unsigned types_in_question) const { return (types & types_in_question) != 0; }
};

/// The root of the tree, built once. Rows of `physics` that are formulas stand also under
/// `physics.materials[]`, and may be given as {from: file, field: name}.
const SchemaKey& schema();

/// "a number", "a number or a list": what a key takes.
std::string type_text(const SchemaKey& key);

// Short forms for the tables.
inline constexpr Presence required{Presence::Kind::required, {}, {}};
inline constexpr Presence optional{};
inline constexpr Presence alternative{Presence::Kind::alternative, {}, {}};
constexpr Presence standard(std::string_view value) {
  return {Presence::Kind::optional, value, {}};
}
inline constexpr Range any_range{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
constexpr Range at_least(double low) { return {low}; }
constexpr Range between(double low, double high) { return {low, high}; }

}  // namespace rfm
