// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/shared_list.hpp>
#include <twum/io/yaml_node.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// Kind of a value in a file.
enum class ValueKind : unsigned char {
  quantity,  ///< a number with a unit; a bare number (or percentage) if dimensionless
  count,     ///< a whole number
  text,      ///< any words
  word,      ///< one of a few words
  mapping,   ///< entries with fixed names
  named,     ///< any number of entries of one shape, with names that the user chooses
  list,      ///< any number of items of one shape
  any_of,    ///< one of several, distinguished by their kind
  variant    ///< one of several mappings, distinguished by the word in one of their entries
};

struct SchemaEntry;

/// The default of an entry that is left out.
struct StandardValue {
  YamlNode value;  ///< as a user types it
  /// entry of the same or an enclosing mapping that decides whether this default applies; empty: always
  std::string selector{};
  std::vector<std::string> words{};  ///< values of that entry for which it applies
};

/// The shape of a file or of a part of it. From this one table a file is checked and documented, and the JSON Schema
/// and the templates are written.
struct Schema {
  ValueKind kind{ValueKind::text};  ///< kind of the value
  std::string text;                 ///< what it is, in one line
  std::string example;              ///< a valid value, as a user types it
  std::string sample;               ///< mapping, named or list: lines of YAML to show in a template

  std::string unit{"1"};  ///< quantity: SI unit, "1" if dimensionless
  double min{-std::numeric_limits<double>::infinity()};  ///< quantity, count: in SI
  double max{std::numeric_limits<double>::infinity()};   ///< likewise
  bool min_excluded{false};                              ///< the value must exceed `min`
  bool max_excluded{false};                              ///< the value must be less than `max`
  bool whole{false};     ///< quantity without unit: whole numbers only
  bool absolute{false};  ///< quantity: an absolute temperature, which may be given in degC

  std::vector<std::string> words;  ///< word: the choices
  std::string
      pattern;  ///< word: regular expression of other texts that may stand there, for editors
  SharedList<SchemaEntry> entries;  ///< mapping
  SharedList<Schema> items;         ///< list, named: one element, what the items are
  std::size_t min_items{1};         ///< list
  std::size_t max_items{std::numeric_limits<std::size_t>::max()};  ///< list
  SharedList<Schema> alternatives;  ///< any_of; variant: one mapping for each of the words
  std::string selector;             ///< variant: the entry whose word decides
  /// text: throws ValueError if the text is wrong
  void (*check)(std::string_view text){nullptr};
};

/// One entry of a mapping.
struct SchemaEntry {
  std::string name;      ///< as it stands in the file
  Schema schema;         ///< shape of its value
  bool required{false};  ///< it must be there
  /// entry that may be given instead of this one. If `required`, exactly one of the two is needed, otherwise at most
  /// one.
  std::string alternative_entry{};
  /// entry that replaces this one and others: if it is given, this one may be left out
  std::string spared_by{};
  std::string alias{};       ///< another name that users may type, used by `did you mean`
  bool alias_counts{false};  ///< the alias is accepted in place of the name
  bool shown{true};          ///< written in templates; otherwise commented out there
  std::string fallback{};    ///< the default in words
  /// the default as values; the first one that applies is used
  std::vector<StandardValue> standards{};
};

/// The entry of a schema at a path such as "motor.stator.frequency"; null if there is none.
const SchemaEntry* find_path(const Schema& root, std::string_view path);

}  // namespace twum::inline v0_1::io
