// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/validate.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>

#include <algorithm>
#include <utility>

namespace twum::studies {
namespace {

std::string join(const std::string& path, const std::string& name) {
  return path.empty() ? name : path + "." + name;
}

// The entry that a key names, by its name or by an alias that counts.
const SchemaEntry* entry_of(const Schema& mapping, std::string_view key) {
  for (const SchemaEntry& entry : mapping.entries) {
    if (entry.name == key || (entry.alias_counts && entry.alias == key)) return &entry;
  }
  return nullptr;
}

// The key of an entry in a mapping; null if it is not given.
const YamlEntry* given(const YamlNode& node, const Schema& mapping, std::string_view name) {
  for (const YamlEntry& entry : node.entries) {
    const SchemaEntry* known = entry_of(mapping, entry.key);
    if (known != nullptr && known->name == name) return &entry;
  }
  return nullptr;
}

// What other kinds of study, and people, call an entry.
std::string_view synonym(std::string_view word, const std::vector<std::string_view>& names) {
  static constexpr std::pair<std::string_view, std::string_view> kSame[] = {
      {"constraints", "limits"}, {"limits", "constraints"},   {"parameters", "variables"},
      {"objective", "maximize"}, {"objective", "objectives"}, {"solvers", "solver"},
      {"method", "sampling"},    {"sampling", "method"},      {"file", "data"}};
  for (const auto& [said, name] : kSame) {
    if (said == word && std::find(names.begin(), names.end(), name) != names.end()) return name;
  }
  return {};
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
      case ValueKind::variant: return check_variant(node, schema, path, place);
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
    const std::size_t count = node.items.size();
    if (count < schema.min_items || count > schema.max_items) {
      diagnostics_.add(node.mark, path, count == 0 ? "an empty list" : counted(count, "item"),
                       count == 0 ? expectation(schema.items.front()) : items_allowed(schema));
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

  static std::string items_allowed(const Schema& schema) {
    const std::string least = std::to_string(schema.min_items);
    if (schema.max_items > 1000000) return "expected at least " + least;
    if (schema.min_items == schema.max_items) return "expected " + least;
    return "expected " + least + " to " + std::to_string(schema.max_items);
  }

  void check_variant(const YamlNode& node, const Schema& schema, const std::string& path,
                     SourceMark place) {
    if (node.kind != YamlNode::Kind::mapping) return wrong_kind(node, schema, path, place);
    const YamlNode* word = node.find(schema.selector);
    for (std::size_t i = 0; word != nullptr && i < schema.words.size(); ++i) {
      if (word->kind == YamlNode::Kind::scalar && word->scalar == schema.words[i]) {
        return check_mapping(node, schema.alternatives[i], path, place);
      }
    }
    Schema words;
    words.kind = ValueKind::word;
    words.words = schema.words;
    if (word != nullptr) return check(*word, words, join(path, schema.selector), word->mark);
    diagnostics_.add(place, join(path, schema.selector), "missing", expectation(words));
  }

  void check_mapping(const YamlNode& node, const Schema& schema, const std::string& path,
                     SourceMark place) {
    if (node.kind != YamlNode::Kind::mapping) return wrong_kind(node, schema, path, place);
    std::vector<std::string_view> meant;  // entries that a mistyped name stands for
    for (const YamlEntry& entry : node.entries) {
      if (const SchemaEntry* known = entry_of(schema, entry.key)) {
        check(entry.value, known->schema, join(path, entry.key), entry.key_mark);
        const YamlEntry* first = given(node, schema, known->name);
        if (first != &entry) given_twice(entry, *first, path);
      } else {
        meant.push_back(unknown(entry, schema, path));
      }
    }
    for (const SchemaEntry& entry : schema.entries) {
      if (std::find(meant.begin(), meant.end(), entry.name) == meant.end()) {
        check_presence(node, schema, entry, path, place);
      }
    }
  }

  // By its name and by its alias; the same key twice was noticed by the reader of YAML.
  void given_twice(const YamlEntry& second, const YamlEntry& first, const std::string& path) {
    diagnostics_.add({second.key_mark, join(path, second.key),
                      "the same as '" + first.key + "', given twice", "leave one of them out",
                      first.key_mark, "'" + first.key + "' given here"});
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
    if (meant.empty()) meant = synonym(entry.key, names);
    diagnostics_.add(entry.key_mark, join(path, entry.key), "unknown entry",
                     meant.empty() ? did_you_mean(entry.key, names)
                                   : "did you mean '" + std::string(meant) + "'?");
    return meant;
  }

  void check_presence(const YamlNode& node, const Schema& schema, const SchemaEntry& entry,
                      const std::string& path, SourceMark place) {
    const YamlEntry* own = given(node, schema, entry.name);
    const YamlEntry* twin = entry.twin.empty() ? nullptr : given(node, schema, entry.twin);
    if (own != nullptr && twin != nullptr) return both_given(*own, *twin, path);
    if (own != nullptr || twin != nullptr || !entry.required) return;
    std::string remedy = expectation(entry.schema);
    if (!entry.twin.empty()) remedy += ", or '" + entry.twin + "' instead";
    diagnostics_.add(place, join(path, entry.name), "missing", remedy);
  }

  // Reported once, at the later of the two.
  void both_given(const YamlEntry& own, const YamlEntry& twin, const std::string& path) {
    if (&own < &twin) return;
    diagnostics_.add({own.key_mark, join(path, own.key),
                      "says the same as '" + twin.key + "' in another way", "give one of the two",
                      twin.key_mark, "'" + twin.key + "' given here"});
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
