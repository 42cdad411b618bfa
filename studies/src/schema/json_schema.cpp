// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/publish.hpp>

#include <nlohmann/json.hpp>

#include <cmath>

namespace twum::studies {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNumber = R"([+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)";

Json convert(const Schema& schema);

void add_limits(Json& json, const Schema& schema) {
  if (std::isfinite(schema.min))
    json[schema.min_excluded ? "exclusiveMinimum" : "minimum"] = schema.min;
  if (std::isfinite(schema.max)) json["maximum"] = schema.max;
}

// A bare number, or the same as text ("5 %").
Json bare_number(const Schema& schema) {
  const bool whole = schema.whole || schema.kind == ValueKind::count;
  Json number{{"type", whole ? "integer" : "number"}};
  add_limits(number, schema);
  Json text{{"type", "string"}, {"pattern", std::string("^\\s*") + kNumber + "\\s*%?\\s*$"}};
  return {{"anyOf", Json::array({number, text})}};
}

// Whether the unit has the right dimension is for the program to say.
Json with_unit(const Schema& schema) {
  return {{"type", "string"},
          {"pattern", std::string("^\\s*") + kNumber + "\\s*[^\\s0-9.,+-].*$"},
          {"description", schema.text + " [" + schema.unit + "]"}};
}

Json one_of_words(const Schema& schema) {
  Json choices = Json::array();
  for (const std::string& word : schema.words) {
    choices.push_back(word);
    // YAML reads 1 as a number, and so do editors.
    if (word.find_first_not_of("0123456789") == std::string::npos)
      choices.push_back(std::stoi(word));
  }
  return {{"enum", choices}};
}

// Exactly one of a needed pair, at most one of any other pair.
Json pair_rule(const SchemaEntry& entry) {
  const auto has = [](const std::string& name) { return Json{{"required", Json::array({name})}}; };
  if (entry.required) return {{"oneOf", Json::array({has(entry.name), has(entry.twin)})}};
  return {{"not", {{"required", Json::array({entry.name, entry.twin})}}}};
}

bool needs_rule(const Schema& mapping, const SchemaEntry& entry) {
  if (entry.twin.empty()) return false;
  if (entry.required) return true;
  for (const SchemaEntry& other : mapping.entries) {
    if (other.name == entry.twin) return !other.required && entry.name < other.name;
  }
  return false;
}

Json mapping(const Schema& schema) {
  Json json{{"type", "object"}, {"additionalProperties", false}};
  Json required = Json::array();
  Json rules = Json::array();
  for (const SchemaEntry& entry : schema.entries) {
    json["properties"][entry.name] = convert(entry.schema);
    if (entry.alias_counts && !entry.alias.empty()) {
      json["properties"][entry.alias] = json["properties"][entry.name];
    }
    if (entry.required && entry.twin.empty()) required.push_back(entry.name);
    if (needs_rule(schema, entry)) rules.push_back(pair_rule(entry));
  }
  if (!required.empty()) json["required"] = required;
  if (!rules.empty()) json["allOf"] = rules;
  return json;
}

Json list(const Schema& schema) {
  Json json{
      {"type", "array"}, {"minItems", schema.min_items}, {"items", convert(schema.items.front())}};
  if (schema.max_items < 1000000) json["maxItems"] = schema.max_items;
  return json;
}

// Each alternative fixes the word of its selector, so at most one of them fits.
Json variant(const Schema& schema) {
  Json choices = Json::array();
  for (const Schema& one : schema.alternatives) choices.push_back(convert(one));
  return {{"type", "object"}, {"required", Json::array({schema.selector})}, {"oneOf", choices}};
}

Json bare(const Schema& schema) {
  switch (schema.kind) {
    case ValueKind::quantity: return schema.unit == "1" ? bare_number(schema) : with_unit(schema);
    case ValueKind::count: return bare_number(schema);
    case ValueKind::word: return one_of_words(schema);
    case ValueKind::mapping: return mapping(schema);
    case ValueKind::list: return list(schema);
    case ValueKind::variant: return variant(schema);
    case ValueKind::any_of: {
      Json choices = Json::array();
      for (const Schema& one : schema.alternatives) choices.push_back(convert(one));
      return {{"anyOf", choices}};
    }
    case ValueKind::text: break;
  }
  return {{"type", Json::array({"string", "number"})}};
}

Json convert(const Schema& schema) {
  Json json = bare(schema);
  if (!schema.text.empty() && !json.contains("description")) json["description"] = schema.text;
  if (!schema.example.empty()) json["examples"] = Json::array({schema.example});
  return json;
}

}  // namespace

std::string json_schema(const Schema& schema, std::string_view title, std::string_view id) {
  Json json{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"$id", id}, {"title", title}};
  json.update(convert(schema));
  return json.dump(2) + "\n";
}

}  // namespace twum::studies
