// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/validate.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>

#include <algorithm>

namespace twum::studies {
namespace {

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "." + name;
}

class Validator {
 public:
  explicit Validator(Diagnostics& diagnostics) : diagnostics_(diagnostics) {}

  // `place` is where to point when the node itself is empty: its key.
  void check(const YamlNode& node, const Schema& schema, const std::string& path,
             SourceMark place) {
    if (node.kind == YamlNode::Kind::refused) return;
    switch (schema.kind) {
      case ValueKind::mapping: return check_mapping(node, schema, path, place);
      case ValueKind::list: return check_list(node, schema, path, place);
      case ValueKind::any_of: return check_any_of(node, schema, path, place);
      default: return check_value(node, schema, path, place);
    }
  }

 private:
  void wrong_kind(const YamlNode& node, const Schema& schema, const std::string& path,
                  SourceMark place) {
    const bool text = node.kind == YamlNode::Kind::scalar;
    diagnostics_.add(node.kind == YamlNode::Kind::empty ? place : node.mark, path,
                     text ? quoted(node.scalar) : std::string(kind_phrase(node.kind)),
                     expectation(schema));
  }

  void check_value(const YamlNode& node, const Schema& schema, const std::string& path,
                   SourceMark place) {
    if (node.kind != YamlNode::Kind::scalar) return wrong_kind(node, schema, path, place);
    try {
      check_scalar(node.scalar, schema);
    } catch (const ValueError& error) {
      diagnostics_.add(node.mark, path, error.found(), error.expected());
    }
  }

  void check_list(const YamlNode& node, const Schema& schema, const std::string& path,
                  SourceMark place) {
    if (node.kind != YamlNode::Kind::list) return wrong_kind(node, schema, path, place);
    if (node.items.empty()) {
      diagnostics_.add(node.mark, path, "an empty list", expectation(schema.items.front()));
    }
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      check(node.items[i], schema.items.front(), path + "[" + std::to_string(i) + "]",
            node.items[i].mark);
    }
  }

  void check_any_of(const YamlNode& node, const Schema& schema, const std::string& path,
                    SourceMark place) {
    for (const Schema& one : schema.alternatives) {
      const bool fits = one.kind == ValueKind::mapping ? node.kind == YamlNode::Kind::mapping
                        : one.kind == ValueKind::list  ? node.kind == YamlNode::Kind::list
                                                       : node.kind == YamlNode::Kind::scalar;
      if (fits) return check(node, one, path, place);
    }
    wrong_kind(node, schema, path, place);
  }

  void check_mapping(const YamlNode& node, const Schema& schema, const std::string& path,
                     SourceMark place) {
    if (node.kind != YamlNode::Kind::mapping) return wrong_kind(node, schema, path, place);
    std::vector<std::string_view> meant;  // entries that a mistyped name stands for
    for (const YamlEntry& entry : node.entries) {
      const auto known = std::find_if(schema.entries.begin(), schema.entries.end(),
                                      [&](const SchemaEntry& e) { return e.name == entry.key; });
      if (known == schema.entries.end()) {
        meant.push_back(unknown(entry, schema, path));
      } else {
        check(entry.value, known->schema, join(path, entry.key), entry.key_mark);
      }
    }
    for (const SchemaEntry& entry : schema.entries) {
      if (std::find(meant.begin(), meant.end(), entry.name) == meant.end()) {
        check_presence(node, entry, path, place);
      }
    }
  }

  // Returns the name that was meant, empty if there is no telling.
  std::string_view unknown(const YamlEntry& entry, const Schema& schema, const std::string& path) {
    std::vector<std::string_view> names;
    std::string_view meant;
    for (const SchemaEntry& known : schema.entries) {
      names.push_back(known.name);
      if (!known.alias.empty() && known.alias == entry.key) meant = known.name;
    }
    if (meant.empty()) meant = nearest(entry.key, names);
    diagnostics_.add(entry.key_mark, join(path, entry.key), "unknown entry",
                     meant.empty() ? did_you_mean(entry.key, names)
                                   : "did you mean '" + std::string(meant) + "'?");
    return meant;
  }

  void check_presence(const YamlNode& node, const SchemaEntry& entry, const std::string& path,
                      SourceMark place) {
    const YamlNode* own = node.find(entry.name);
    const YamlNode* twin = entry.twin.empty() ? nullptr : node.find(entry.twin);
    if (own != nullptr && twin != nullptr) return both_given(node, entry, path);
    if (own != nullptr || twin != nullptr || !entry.required) return;
    std::string remedy = expectation(entry.schema);
    if (!entry.twin.empty()) remedy += ", or its twin '" + entry.twin + "'";
    diagnostics_.add(place, join(path, entry.name), "missing", remedy);
  }

  // Reported once, at the later of the two.
  void both_given(const YamlNode& node, const SchemaEntry& entry, const std::string& path) {
    const auto key = [&](const std::string& name) {
      return std::find_if(node.entries.begin(), node.entries.end(),
                          [&](const YamlEntry& e) { return e.key == name; });
    };
    const auto own = key(entry.name);
    const auto twin = key(entry.twin);
    if (own < twin) return;
    diagnostics_.add({own->key_mark, join(path, entry.name),
                      "says the same as '" + entry.twin + "' in another way", "give one of the two",
                      twin->key_mark, "'" + entry.twin + "' given here"});
  }

  Diagnostics& diagnostics_;
};

}  // namespace

void validate(const YamlNode& root, const Schema& schema, Diagnostics& diagnostics) {
  Validator(diagnostics).check(root, schema, {}, {1, 1});
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
