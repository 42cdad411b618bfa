// SPDX-License-Identifier: Apache-2.0
#pragma once

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
  list,      ///< any number of the same
  any_of     ///< one of several, told apart by their kind
};

struct SchemaEntry;

/// The shape of a file, or of a part of it: the one table from which it is checked, documented,
/// published as JSON Schema, and written as a file to start from.
struct Schema {
  ValueKind kind{ValueKind::text};
  std::string text;     ///< what it is, in one line
  std::string example;  ///< a valid value, as one would type it

  std::string unit{"1"};  ///< quantity: SI unit, "1" if dimensionless
  double min{-std::numeric_limits<double>::infinity()};  ///< quantity, count: in SI
  double max{std::numeric_limits<double>::infinity()};
  bool min_excluded{false};
  bool whole{false};  ///< quantity without unit: whole numbers only

  std::vector<std::string> words;    ///< word: the choices
  std::vector<SchemaEntry> entries;  ///< mapping
  std::vector<Schema> items;         ///< list: one element, what the items are
  std::vector<Schema> alternatives;  ///< any_of
  std::string (*complaint)(std::string_view text){nullptr};  ///< text: "found; expected" or empty
};

/// One entry of a mapping.
struct SchemaEntry {
  std::string name;
  Schema schema;
  bool required{false};
  std::string twin{};   ///< entry that says the same in another way: exactly one of both is needed
                        ///< if `required`, at most one if not
  std::string alias{};  ///< another name people may type; understood only in `did you mean`
  std::string fallback{};  ///< what holds if it is left out, in words
};

}  // namespace twum::studies
