// SPDX-License-Identifier: Apache-2.0
#include <twum/io/publish.hpp>

#include <nlohmann/json.hpp>

#include <cmath>
#include <map>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kNumber = R"([+-]?([0-9]+\.?[0-9]*|\.[0-9]+)([eE][+-]?[0-9]+)?)";

void add_limits(Json& json, const Schema& schema) {
  if (std::isfinite(schema.min))
    json[schema.min_excluded ? "exclusiveMinimum" : "minimum"] = schema.min;
  if (std::isfinite(schema.max))
    json[schema.max_excluded ? "exclusiveMaximum" : "maximum"] = schema.max;
}

// A bare number, or the same as text ("5 %").
Json bare_number(const Schema& schema) {
  const bool whole = schema.whole || schema.kind == ValueKind::count;
  Json number{{"type", whole ? "integer" : "number"}};
  add_limits(number, schema);
  Json text{{"type", "string"}, {"pattern", std::string("^\\s*") + kNumber + "\\s*%?\\s*$"}};
  return {{"anyOf", Json::array({number, text})}};
}

// A JSON Schema cannot check the dimension of the unit; the program does.
Json with_unit(const Schema& schema) {
  return {{"type", "string"},
          {"pattern", std::string("^\\s*") + kNumber + "\\s*[^\\s0-9.,+-].*$"},
          {"description", schema.text + " [" + schema.unit + "]"}};
}

Json one_of_words(const Schema& schema) {
  Json choices = Json::array();
  for (const std::string& word : schema.words) {
    choices.push_back(word);
    // YAML and editors read 1 as a number, not as a text.
    if (word.find_first_not_of("0123456789") == std::string::npos)
      choices.push_back(std::stoi(word));
  }
  const Json words{{"enum", choices}};
  if (schema.pattern.empty()) return words;
  return {{"anyOf", Json::array({words, {{"type", "string"}, {"pattern", schema.pattern}}})}};
}

Json has(const std::string& name) { return {{"required", Json::array({name})}}; }

// The condition that an entry is given, by its name or by an accepted alias.
Json is_given(const SchemaEntry& entry) {
  if (!entry.alias_counts || entry.alias.empty()) return has(entry.name);
  return {{"anyOf", Json::array({has(entry.name), has(entry.alias)})}};
}

const SchemaEntry* alternative_entry_of(const Schema& mapping, const SchemaEntry& entry) {
  for (const SchemaEntry& other : mapping.entries) {
    if (!entry.alternative_entry.empty() && other.name == entry.alternative_entry) return &other;
  }
  return nullptr;
}

// Rule for a pair of alternatives: exactly one if they are required, else at most one. Added once for each pair.
void add_pair_rule(Json& rules, const Schema& mapping, const SchemaEntry& entry) {
  const SchemaEntry* alternative = alternative_entry_of(mapping, entry);
  if (alternative == nullptr) return;
  const Json both = Json::array({is_given(entry), is_given(*alternative)});
  if (entry.required && !entry.spared_by.empty()) {
    rules.push_back({{"not", {{"allOf", both}}}});
  } else if (entry.required) {
    rules.push_back({{"oneOf", both}});
  } else if (!alternative->required && entry.name < alternative->name) {
    rules.push_back({{"not", {{"allOf", both}}}});
  }
}

// Rule: the entry, its alternative, or the entry that replaces it.
void add_spared_rule(Json& rules, const Schema& mapping, const SchemaEntry& entry) {
  Json any = Json::array({is_given(entry)});
  if (const SchemaEntry* alternative = alternative_entry_of(mapping, entry))
    any.push_back(is_given(*alternative));
  any.push_back({{"required", {entry.spared_by}}});
  rules.push_back({{"anyOf", any}});
}

// Converts schemas, and keeps the long pieces that it meets more than once: most shapes of a study
// repeat for every parameter.
class Converter {
 public:
  Json convert(const Schema& schema) {
    Json json = bare(schema);
    if (!schema.text.empty() && !json.contains("description")) json["description"] = schema.text;
    if (!schema.example.empty()) json["examples"] = Json::array({schema.example});
    return json;
  }

  // The pieces, by the name they are referred to.
  const Json& definitions() const { return definitions_; }

 private:
  Json shared(const Schema& schema) {
    constexpr std::size_t kLong = 300;  // characters
    Json json = convert(schema);
    const std::string text = json.dump();
    if (text.size() < kLong) return json;
    const auto [place, fresh] = names_.emplace(text, "part" + std::to_string(names_.size() + 1));
    if (fresh) definitions_[place->second] = std::move(json);
    return {{"$ref", "#/$defs/" + place->second}};
  }

  Json mapping(const Schema& schema) {
    Json json{{"type", "object"}, {"additionalProperties", false}};
    Json required = Json::array();
    Json rules = Json::array();
    for (const SchemaEntry& entry : schema.entries) {
      json["properties"][entry.name] = shared(entry.schema);
      if (entry.alias_counts && !entry.alias.empty()) {
        json["properties"][entry.alias] = json["properties"][entry.name];
      }
      const bool spared = !entry.spared_by.empty();
      if (entry.required && entry.alternative_entry.empty() && !spared)
        required.push_back(entry.name);
      if (entry.required && spared) add_spared_rule(rules, schema, entry);
      add_pair_rule(rules, schema, entry);
    }
    if (!required.empty()) json["required"] = required;
    if (!rules.empty()) json["allOf"] = rules;
    return json;
  }

  Json list(const Schema& schema) {
    Json json{
        {"type", "array"}, {"minItems", schema.min_items}, {"items", shared(schema.items.front())}};
    if (schema.max_items < 1000000) json["maxItems"] = schema.max_items;
    return json;
  }

  Json named(const Schema& schema) {
    return {{"type", "object"},
            {"minProperties", 1},
            {"additionalProperties", shared(schema.items.front())}};
  }

  // Each alternative fixes the word of its selector, so at most one of them fits.
  Json variant(const Schema& schema) {
    Json choices = Json::array();
    for (const Schema& one : schema.alternatives) choices.push_back(shared(one));
    return {{"type", "object"}, {"required", Json::array({schema.selector})}, {"oneOf", choices}};
  }

  Json any_of(const Schema& schema) {
    Json choices = Json::array();
    for (const Schema& one : schema.alternatives) choices.push_back(shared(one));
    return {{"anyOf", choices}};
  }

  Json bare(const Schema& schema) {
    switch (schema.kind) {
      case ValueKind::quantity: return schema.unit == "1" ? bare_number(schema) : with_unit(schema);
      case ValueKind::count: return bare_number(schema);
      case ValueKind::word: return one_of_words(schema);
      case ValueKind::mapping: return mapping(schema);
      case ValueKind::named: return named(schema);
      case ValueKind::list: return list(schema);
      case ValueKind::variant: return variant(schema);
      case ValueKind::any_of: return any_of(schema);
      case ValueKind::text: break;
    }
    return {{"type", Json::array({"string", "number"})}};
  }

  std::map<std::string, std::string> names_;
  Json definitions_ = Json::object();
};

}  // namespace

std::string json_schema(const Schema& schema, std::string_view title, std::string_view id) {
  Json json{
      {"$schema", "https://json-schema.org/draft/2020-12/schema"}, {"$id", id}, {"title", title}};
  Converter converter;
  json.update(converter.convert(schema));
  if (!converter.definitions().empty()) json["$defs"] = converter.definitions();
  return json.dump(2) + "\n";
}

}  // namespace twum::inline v0_1::io
