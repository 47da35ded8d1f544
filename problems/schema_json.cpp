#include <nlohmann/json.hpp>

#include "problems/schema.hpp"
#include "problems/schema_text.hpp"

namespace rfm {
namespace {

using Json = nlohmann::ordered_json;

Json map_schema(const SchemaKey& key);
Json value_schema(const SchemaKey& key);

// A number may always be an expression of parameters, which is a text.
Json number_schema(const SchemaKey& key, const char* type) {
  Json number = {{"type", type}};
  if (key.range.low != Range{}.low)
    number[key.range.low_excluded ? "exclusiveMinimum" : "minimum"] = key.range.low;
  if (key.range.high != Range{}.high) number["maximum"] = key.range.high;
  return {{"anyOf", Json::array({number, {{"type", "string"}}})}};
}

Json word_schema(const SchemaKey& key) {
  Json words = Json::array();
  for (const SchemaKey& word : key.words) {
    if (word.status == Status::later) continue;
    const bool is_number = word.name.find_first_not_of("0123456789") == std::string::npos;
    words.push_back(is_number ? Json(std::stoi(word.name)) : Json(word.name));
  }
  return {{"enum", words}};
}

Json list_of(Json items) { return {{"type", "array"}, {"items", std::move(items)}}; }

std::vector<Json> type_schemas(const SchemaKey& key) {
  const Json formula = {{"type", Json::array({"number", "string"})}};
  std::vector<Json> schemas;
  if (key.takes(number_value)) schemas.push_back(number_schema(key, "number"));
  if (key.takes(integer_value)) schemas.push_back(number_schema(key, "integer"));
  if (key.takes(boolean_value)) schemas.push_back({{"type", "boolean"}});
  if (key.takes(word_value)) schemas.push_back(word_schema(key));
  if (key.takes(expression_value | result_value | text_value)) schemas.push_back(formula);
  if (key.takes(name_value | shapes_value | file_value)) schemas.push_back({{"type", "string"}});
  if (key.takes(vector_value | numbers_value)) schemas.push_back(list_of(formula));
  if (key.takes(matrix_value)) schemas.push_back(list_of(list_of(formula)));
  if (key.takes(list_value))
    schemas.push_back(list_of(key.items.empty() ? Json::object() : value_schema(key.items[0])));
  if (key.takes(functions_value))
    schemas.push_back({{"type", "object"}, {"additionalProperties", formula}});
  if (key.takes(named_map_value))
    schemas.push_back({{"type", "object"}, {"additionalProperties", value_schema(key.named[0])}});
  const bool has_keys =
      key.path.empty() || std::any_of(key.keys.begin(), key.keys.end(), [](const SchemaKey& child) {
        return child.status == Status::works;
      });
  if (key.takes(map_value) && has_keys) schemas.push_back(map_schema(key));
  return schemas;
}

Json value_schema(const SchemaKey& key) {
  const std::vector<Json> schemas = type_schemas(key);
  Json schema = schemas.size() == 1 ? schemas[0] : Json{{"anyOf", schemas}};
  if (!key.doc.empty()) schema["description"] = key.doc;
  if (!key.presence.standard.empty()) schema["default"] = std::string(key.presence.standard);
  return schema;
}

Json map_schema(const SchemaKey& key) {
  Json properties = Json::object(), needed = Json::array(), alternatives = Json::array();
  bool has_standard_alternative = false;
  for (const SchemaKey& child : key.keys) {
    if (child.status == Status::later) continue;
    properties[child.name] = value_schema(child);
    const bool is_unconditional = child.when.empty() && child.presence.unless.empty();
    if (child.presence.kind == Presence::Kind::required && is_unconditional)
      needed.push_back(child.name);
    if (child.presence.kind != Presence::Kind::alternative) continue;
    Json alternative = {{"required", Json::array({child.name})}};
    if (!child.presence.unless.empty())
      alternative["not"] = {{"required", Json::array({std::string(child.presence.unless)})}};
    alternatives.push_back(std::move(alternative));
    has_standard_alternative |= !child.presence.standard.empty();
  }
  Json schema = {{"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!needed.empty()) schema["required"] = needed;
  if (!alternatives.empty() && !has_standard_alternative) schema["oneOf"] = alternatives;
  return schema;
}

}  // namespace

std::string json_schema_text() {
  Json schema = {{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                 {"title", "Problem file of rfm-solve"}};
  schema.update(map_schema(rfm::schema()));
  return schema.dump(2) + "\n";
}

}  // namespace rfm
