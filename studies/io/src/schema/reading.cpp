// SPDX-License-Identifier: Apache-2.0
#include <twum/io/shape.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/io/number.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <map>
#include <set>

namespace twum::inline v0_1::io {
namespace {

// The entry with a name or an accepted alias equal to the key.
const SchemaEntry* entry_of(const Schema& mapping, std::string_view key) {
  for (const SchemaEntry& entry : mapping.entries) {
    if (entry.name == key || (entry.alias_counts && entry.alias == key)) return &entry;
  }
  return nullptr;
}

// The first entry of a mapping for each entry of its schema, found in one pass.
class FirstGiven {
 public:
  FirstGiven(const YamlNode& node, const Schema& mapping) {
    for (const YamlEntry& entry : node.entries)
      if (const SchemaEntry* known = entry_of(mapping, entry.key))
        first_.emplace(known->name, &entry);
  }

  // Null if it is not given.
  const YamlEntry* find(std::string_view name) const {
    const auto found = first_.find(name);
    return found == first_.end() ? nullptr : found->second;
  }

 private:
  std::map<std::string_view, const YamlEntry*> first_;
};

// Another usual name of an entry, as in other kinds of study.
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

// Adds an error for an entry given both by its name and by its alias. The YAML reader detects equal keys.
void say_twice(const YamlEntry& second, const YamlEntry& first, const Spot& spot,
               Diagnostics& diagnostics) {
  const Spot place = spot.entry(second.key, second.key_mark);
  diagnostics.add({place.mark, place.path, "the same as '" + first.key + "', given twice",
                   "leave one of them out", first.key_mark, "'" + first.key + "' given here"});
}

// The required mapping that is missing and to which an unknown entry belongs; null if there is none, or more than one.
const SchemaEntry* missing_parent(const FirstGiven& given, const Schema& schema,
                                  std::string_view key) {
  const SchemaEntry* parent = nullptr;
  for (const SchemaEntry& entry : schema.entries) {
    if (!entry.required || entry.schema.kind != ValueKind::mapping ||
        given.find(entry.name) != nullptr || entry_of(entry.schema, key) == nullptr)
      continue;
    if (parent != nullptr) return nullptr;
    parent = &entry;
  }
  return parent;
}

// Adds an error for an unknown entry. Returns the name that was probably meant, or an empty text.
std::string_view say_unknown(const YamlEntry& entry, const Schema& schema, const Spot& spot,
                             Diagnostics& diagnostics) {
  std::vector<std::string_view> names;
  std::string_view meant;
  for (const SchemaEntry& known : schema.entries) {
    names.push_back(known.name);
    if (!known.alias.empty() && known.alias == entry.key) meant = known.name;
  }
  if (meant.empty()) meant = nearest(entry.key, names);
  if (meant.empty()) meant = synonym(entry.key, names);
  const std::string remedy = !meant.empty()         ? "did you mean '" + std::string(meant) + "'?"
                             : by_parameter(schema) ? "'twum parameters' lists the parameters"
                                                    : did_you_mean(entry.key, names);
  diagnostics.add(entry.key_mark, spot.entry(entry.key, {}).path, "unknown entry", remedy);
  return meant;
}

// Adds an error for an entry that stands beside its missing parent instead of below it.
void say_misplaced(const YamlEntry& entry, const SchemaEntry& parent, const Spot& spot,
                   Diagnostics& diagnostics) {
  diagnostics.add(entry.key_mark, spot.entry(entry.key, {}).path,
                  "belongs below '" + parent.name + ":', which is missing",
                  "write '" + parent.name + ":' above it and indent what belongs to it");
}

// Adds an error for an entry and its alternative, once, at the later of the two.
void say_both(const YamlEntry& own, const YamlEntry& alternative, const Spot& spot,
              Diagnostics& diagnostics) {
  if (&own < &alternative) return;
  diagnostics.add({own.key_mark, spot.entry(own.key, {}).path,
                   "cannot be given together with '" + alternative.key + "'", "give one of the two",
                   alternative.key_mark, "'" + alternative.key + "' given here"});
}

void check_presence(const FirstGiven& given, const SchemaEntry& entry, const Spot& spot,
                    Diagnostics& diagnostics) {
  const YamlEntry* own = given.find(entry.name);
  const YamlEntry* alternative =
      entry.alternative_entry.empty() ? nullptr : given.find(entry.alternative_entry);
  if (own != nullptr && alternative != nullptr)
    return say_both(*own, *alternative, spot, diagnostics);
  const bool spared = !entry.spared_by.empty() && given.find(entry.spared_by) != nullptr;
  if (own != nullptr || alternative != nullptr || spared || !entry.required) return;
  const bool one_word = entry.schema.kind == ValueKind::word && entry.schema.words.size() == 1;
  std::string remedy = one_word
                           ? "expected '" + entry.name + ": " + entry.schema.words.front() + "'"
                           : expectation(entry.schema);
  if (!entry.alternative_entry.empty()) remedy += ", or '" + entry.alternative_entry + "' instead";
  if (!entry.spared_by.empty()) remedy += ", or '" + entry.spared_by + "'";
  diagnostics.add(spot.mark, spot.entry(entry.name, {}).path, "missing", remedy);
}

std::string items_allowed(const Schema& schema) {
  const std::string least = std::to_string(schema.min_items);
  if (schema.max_items > 1000000) return "expected at least " + least;
  if (schema.min_items == schema.max_items) return "expected " + least;
  return "expected " + least + " to " + std::to_string(schema.max_items);
}

// The shortest text of a number, with an exponent such as 1e-6.
std::string plain_number(double value) {
  std::string text = number_text(value);
  const std::size_t at = text.find("e-0");
  return at == std::string::npos ? text : text.erase(at + 2, 1);
}

bool fits(const YamlNode& node, const Schema& schema) {
  if (schema.kind == ValueKind::mapping || schema.kind == ValueKind::named)
    return node.kind == YamlNode::Kind::mapping;
  if (schema.kind == ValueKind::list) return node.kind == YamlNode::Kind::list;
  return node.kind == YamlNode::Kind::scalar;
}

}  // namespace

void say_wrong_kind(const YamlNode& node, const Schema& schema, const Spot& spot,
                    Diagnostics& diagnostics) {
  if (node.kind == YamlNode::Kind::refused) return;
  const std::string expected = expectation(schema);
  if (node.kind == YamlNode::Kind::empty) {
    diagnostics.add(spot.mark, spot.path, std::string(kind_phrase(node.kind)), expected);
    return;
  }
  const bool text = node.kind == YamlNode::Kind::scalar;
  diagnostics.add(node.mark, spot.path,
                  "found " + (text ? quoted(node.scalar) : std::string(kind_phrase(node.kind))),
                  expected);
}

bool says_no_error(const YamlNode& node, const Schema& schema, const Spot& spot,
                   Diagnostics& diagnostics, const std::function<void(const std::string&)>& use) {
  if (node.kind != YamlNode::Kind::scalar) {
    say_wrong_kind(node, schema, spot, diagnostics);
    return false;
  }
  try {
    if (node.scalar.empty() && schema.kind == ValueKind::text)
      throw ValueError("empty", expectation(schema));
    use(node.scalar);
    return true;
  } catch (const ValueError& error) {
    // a position within a long text is reported
    const bool long_text = schema.kind == ValueKind::text;
    diagnostics.add(long_text
                        ? diagnostics.source().mark_within(node.mark, node.scalar, error.position())
                        : node.mark,
                    spot.path, error.found(), error.expected());
    return false;
  }
}

bool check_item_count(const YamlNode& list, const Schema& schema, const Spot& spot,
                      Diagnostics& diagnostics) {
  const std::size_t count = list.items.size();
  if (count >= schema.min_items && count <= schema.max_items) return true;
  diagnostics.add(list.mark, spot.path,
                  count == 0 ? "found an empty list" : "found " + counted(count, "item"),
                  count == 0 ? expectation(schema.items.front()) : items_allowed(schema));
  return false;
}

std::vector<GivenEntry> given_entries(const YamlNode& node, const Schema& schema, const Spot& spot,
                                      Diagnostics& diagnostics) {
  std::vector<GivenEntry> found;
  const FirstGiven given(node, schema);
  std::set<std::string_view> meant;  // entries that mistyped names were probably meant for
  for (const YamlEntry& entry : node.entries) {
    const SchemaEntry* known = entry_of(schema, entry.key);
    if (known == nullptr) {
      const SchemaEntry* parent = missing_parent(given, schema, entry.key);
      if (parent == nullptr) {
        meant.insert(say_unknown(entry, schema, spot, diagnostics));
      } else if (meant.insert(parent->name).second) {  // once for all entries of the same parent
        say_misplaced(entry, *parent, spot, diagnostics);
      }
      continue;
    }
    found.push_back({static_cast<std::size_t>(known - schema.entries.data()), &entry});
    const YamlEntry* first = given.find(known->name);
    if (first != &entry) say_twice(entry, *first, spot, diagnostics);
  }
  for (const SchemaEntry& entry : schema.entries)
    if (!meant.contains(entry.name)) check_presence(given, entry, spot, diagnostics);
  return found;
}

std::optional<std::size_t> alternative_of(const YamlNode& node, const Schema& schema,
                                          const Spot& spot, Diagnostics& diagnostics) {
  if (schema.kind == ValueKind::any_of) {
    for (std::size_t i = 0; i < schema.alternatives.size(); ++i)
      if (fits(node, schema.alternatives[i])) return i;
    say_wrong_kind(node, schema, spot, diagnostics);
    return {};
  }
  if (node.kind != YamlNode::Kind::mapping) {
    say_wrong_kind(node, schema, spot, diagnostics);
    return {};
  }
  Schema words;
  words.kind = ValueKind::word;
  words.words = schema.words;
  const YamlNode* word = node.find(schema.selector);
  const Spot place = spot.entry(schema.selector, word == nullptr ? spot.mark : word->mark);
  if (word == nullptr) {
    diagnostics.add(place.mark, place.path, "missing", expectation(words));
    return {};
  }
  const auto which = std::find(schema.words.begin(), schema.words.end(), word->scalar);
  if (word->kind == YamlNode::Kind::scalar && which != schema.words.end())
    return static_cast<std::size_t>(which - schema.words.begin());
  says_no_error(*word, words, place, diagnostics,
                [&](const std::string& text) { check_scalar(text, words); });
  return {};
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

YamlNode scalar_node(std::string text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.scalar = std::move(text);
  return node;
}

std::string typed_text(const YamlNode& value) {
  std::string text = value.scalar;
  for (const YamlNode& item : value.items) text += (text.empty() ? "" : ", ") + item.scalar;
  return text;
}

Shape<double> number(Schema schema) {
  Shape<double> shape;
  shape.schema = std::move(schema);
  shape.read = [schema = kept(shape.schema)](double& into, const YamlNode& node, const Spot& spot,
                                             Diagnostics& diagnostics) {
    return says_no_error(node, *schema, spot, diagnostics, [&](const std::string& text) {
      // set for checks of several entries, even if it is out of range
      into = parse_number_of(text, *schema);
      check_size(into, text, *schema);
    });
  };
  shape.write = [unit = shape.schema.unit](const double& value) {
    return scalar_node(plain_number(value) + (unit == "1" ? "" : " " + unit));
  };
  return shape;
}

Shape<double> quantity(std::string text, std::string unit, std::string example) {
  Schema schema;
  schema.kind = ValueKind::quantity;
  schema.text = std::move(text);
  schema.unit = std::move(unit);
  schema.example = std::move(example);
  return number(std::move(schema));
}

Shape<double> fraction(std::string text, std::string example) {
  Schema schema = quantity(std::move(text), "1", std::move(example)).schema;
  schema.min = 0;
  schema.min_excluded = true;
  schema.max = 1;
  schema.max_excluded = true;
  return number(std::move(schema));
}

Shape<std::uint64_t> count(std::string text, std::string example, double least, double most) {
  Schema schema;
  schema.kind = ValueKind::count;
  schema.text = std::move(text);
  schema.example = std::move(example);
  schema.min = least;
  schema.max = most;
  Shape<std::uint64_t> shape = shape_as<std::uint64_t, double>(
      number(std::move(schema)), [](double value) { return static_cast<std::uint64_t>(value); },
      [](const std::uint64_t& value) { return static_cast<double>(value); });
  shape.write = [](const std::uint64_t& value) { return scalar_node(std::to_string(value)); };
  return shape;
}

Shape<std::string> path(std::string text, std::string example) {
  return text_of<std::string>(
      std::move(text), std::move(example),
      [](std::string_view typed) { return std::string(typed); },
      [](const std::string& value) { return value; });
}

Shape<std::size_t> choice(std::string text, std::vector<std::string> words) {
  Shape<std::size_t> shape;
  shape.schema.kind = ValueKind::word;
  shape.schema.text = std::move(text);
  shape.schema.example = words.front();
  shape.schema.words = std::move(words);
  shape.read = [schema = kept(shape.schema)](std::size_t& into, const YamlNode& node,
                                             const Spot& spot, Diagnostics& diagnostics) {
    return says_no_error(node, *schema, spot, diagnostics, [&](const std::string& typed) {
      check_scalar(typed, *schema);
      const auto found = std::find(schema->words.begin(), schema->words.end(), typed);
      into = static_cast<std::size_t>(found - schema->words.begin());
    });
  };
  shape.write = [words = shape.schema.words](const std::size_t& value) {
    // the number in place of a word that there is not, which a reader refuses
    return scalar_node(value < words.size() ? words[value] : std::to_string(value));
  };
  return shape;
}

}  // namespace twum::inline v0_1::io
