// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/validate.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/studies/schema/shape.hpp>
#include <twum/studies/text/value_error.hpp>

namespace twum::studies {
namespace {

class Validator {
 public:
  explicit Validator(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  void check(const YamlNode& node, const Schema& schema, const Spot& spot) {
    switch (schema.kind) {
      case ValueKind::mapping: return check_mapping(node, schema, spot);
      case ValueKind::list: return check_list(node, schema, spot);
      case ValueKind::any_of:
      case ValueKind::variant:
        if (const auto which = alternative_of(node, schema, spot, diagnostics_))
          check(node, schema.alternatives[*which], spot);
        return;
      default:
        says_no_error(node, schema, spot, diagnostics_,
                      [&](const std::string& text) { check_scalar(text, schema); });
    }
  }

 private:
  void check_list(const YamlNode& node, const Schema& schema, const Spot& spot) {
    if (node.kind != YamlNode::Kind::list) return say_wrong_kind(node, schema, spot, diagnostics_);
    check_item_count(node, schema, spot, diagnostics_);
    for (std::size_t i = 0; i < node.items.size(); ++i)
      check(node.items[i], schema.items.front(),
            {spot.path + "[" + std::to_string(i) + "]", node.items[i].mark});
  }

  void check_mapping(const YamlNode& node, const Schema& schema, const Spot& spot) {
    if (node.kind != YamlNode::Kind::mapping)
      return say_wrong_kind(node, schema, spot, diagnostics_);
    for (const auto& [number, entry] : given_entries(node, schema, spot, diagnostics_))
      check(entry->value, schema.entries[number].schema, spot.entry(entry->key, entry->key_mark));
  }

  Diagnostics& diagnostics_;
};

}  // namespace

void validate(const YamlNode& root, const Schema& schema, Diagnostics& diagnostics) {
  validate(root, schema, {{}, {1, 1}}, diagnostics);
}

void validate(const YamlNode& node, const Schema& schema, const Spot& spot,
              Diagnostics& diagnostics) {
  Validator(diagnostics).check(node, schema, spot);
}

std::optional<double> quantity_of(const YamlNode& node, const Schema& schema) {
  if (node.kind != YamlNode::Kind::scalar) return {};
  try {
    return read_number(node.scalar, schema);
  } catch (const ValueError&) {
    return {};
  }
}

const YamlNode* find_path(const YamlNode& root, std::string_view path) {
  const YamlNode* node = &root;
  while (node != nullptr && !path.empty()) {
    const std::size_t dot = path.find('.');
    node = node->find(path.substr(0, dot));
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return node;
}

const SchemaEntry* find_path(const Schema& root, std::string_view path) {
  const Schema* level = &root;
  const SchemaEntry* found = nullptr;
  while (!path.empty()) {
    const std::size_t dot = path.find('.');
    const std::string_view name = path.substr(0, dot);
    found = nullptr;
    for (const SchemaEntry& entry : level->entries) {
      if (entry.name == name) found = &entry;
    }
    if (found == nullptr) return nullptr;
    level = &found->schema;
    path = dot == std::string_view::npos ? std::string_view() : path.substr(dot + 1);
  }
  return found;
}

}  // namespace twum::studies
