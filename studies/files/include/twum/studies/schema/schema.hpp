// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/yaml/node.hpp>

#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace twum::studies {

/// What may stand in one place of a file.
enum class ValueKind : unsigned char {
  quantity,  ///< a number with a unit; a bare number (or percentage) if dimensionless
  count,     ///< a whole number
  text,      ///< any words
  word,      ///< one of a few words
  mapping,   ///< entries with fixed names
  named,     ///< entries with names of the user's own, any number of the same
  list,      ///< any number of the same
  any_of,    ///< one of several, told apart by their kind
  variant    ///< one of several mappings, told apart by the word in one of their entries
};

struct SchemaEntry;

/// The value of an entry that is left out.
struct StandardValue {
  YamlNode value;          ///< as one would type it
  std::string selector{};  ///< entry of the same mapping, or of one around it, that decides
                           ///< whether it holds; empty: it always does
  std::vector<std::string> words{};  ///< of that entry
};

/// The shape of a file, or of a part of it: the one table from which it is checked, documented,
/// published as JSON Schema, and written as a file to start from.
struct Schema {
  ValueKind kind{ValueKind::text};  ///< what may stand there
  std::string text;                 ///< what it is, in one line
  std::string example;              ///< a valid value, as one would type it
  std::string sample;  ///< mapping, named or list: lines of YAML to show in a file to start from

  std::string unit{"1"};  ///< quantity: SI unit, "1" if dimensionless
  double min{-std::numeric_limits<double>::infinity()};  ///< quantity, count: in SI
  double max{std::numeric_limits<double>::infinity()};   ///< likewise
  bool min_excluded{false};                              ///< the value must exceed `min`
  bool max_excluded{false};                              ///< the value must be less than `max`
  bool whole{false};  ///< quantity without unit: whole numbers only

  std::vector<std::string> words;    ///< word: the choices
  std::vector<SchemaEntry> entries;  ///< mapping
  std::vector<Schema> items;         ///< list, named: one element, what the items are
  std::size_t min_items{1};          ///< list
  std::size_t max_items{std::numeric_limits<std::size_t>::max()};  ///< list
  std::vector<Schema> alternatives;  ///< any_of; variant: one mapping for each of the words
  std::string selector;              ///< variant: the entry whose word decides
  /// text: throws ValueError if it is wrong
  void (*check)(std::string_view text){nullptr};
};

/// One entry of a mapping.
struct SchemaEntry {
  std::string name;      ///< as it stands in the file
  Schema schema;         ///< what may stand there
  bool required{false};  ///< it must be there
  std::string twin{};    ///< entry that says the same in another way: exactly one of both is needed
                         ///< if `required`, at most one if not
  std::string
      spared_by{};      ///< entry that may stand for this one and for others: if it is given this
                        ///< one may be left out
  std::string alias{};  ///< another name people may type, understood in `did you mean`
  bool alias_counts{false};  ///< the alias is as good as the name
  bool shown{true};          ///< in a file to start from; otherwise commented out there
  std::string fallback{};    ///< what holds if it is left out, in words
  std::vector<StandardValue> standards{};  ///< the same as values; the first that holds counts
};

/// The entry of a schema at a path such as "motor.stator.frequency"; null if there is none.
const SchemaEntry* find_path(const Schema& root, std::string_view path);

}  // namespace twum::studies
