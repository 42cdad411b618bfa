// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/schema/schema.hpp>
#include <twum/studies/yaml/node.hpp>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace twum::studies {

/// Place of a value in a file.
struct Spot {
  std::string path;  ///< such as "study.variables.preload.min"
  SourceMark mark;   ///< its key, where errors point if it has no value

  /// The place of an entry of the mapping at this place.
  Spot entry(const std::string& name, SourceMark key) const {
    return {path.empty() ? name : path + "." + name, key};
  }
};

/// How a value of one type is represented in a file: admissible values, reading and writing. From one shape follow
/// errors with places, defaults, JSON Schema, templates and reference pages.
template <typename T>
struct Shape {
  Schema schema;  ///< what may stand there
  /// Sets the value, or as much of it as can be read. If something is wrong, adds diagnostics and returns false.
  std::function<bool(T&, const YamlNode&, const Spot&, Diagnostics&)> read;
  /// The value as a user types it; read() gives back the same value.
  std::function<YamlNode(const T&)> write;
};

/// @name Values of one word or number
/// @{
/// A text as a node of YAML.
YamlNode scalar_node(std::string text);
/// A number described by a schema of kind quantity or count, in SI.
Shape<double> number(Schema schema);
/// A number with a unit of this dimension, in SI.
Shape<double> quantity(std::string text, std::string unit, std::string example);
/// A number between 0 and 1, ends excluded.
Shape<double> fraction(std::string text, std::string example);
/// A whole number from `least` to `most`.
Shape<std::uint64_t> count(std::string text, std::string example, double least, double most);
/// Any text, as typed.
Shape<std::string> path(std::string text, std::string example);
/// One of several words; the value is the index of the word.
Shape<std::size_t> choice(std::string text, std::vector<std::string> words);
/// @}

/// A value that the copies of a function object share.
template <typename V>
std::shared_ptr<const V> kept(V value) {
  return std::make_shared<const V>(std::move(value));
}

/// Adds the error that a value of another kind was found than the schema expects.
void say_wrong_kind(const YamlNode& node, const Schema& schema, const Spot& spot,
                    Diagnostics& diagnostics);
/// Passes the text of a value to `use`. If `use` throws a ValueError, adds it to the diagnostics and returns false.
bool says_no_error(const YamlNode& node, const Schema& schema, const Spot& spot,
                   Diagnostics& diagnostics, const std::function<void(const std::string&)>& use);
/// If the number of items is wrong, adds an error and returns false.
bool check_item_count(const YamlNode& list, const Schema& schema, const Spot& spot,
                      Diagnostics& diagnostics);
/// An entry of a mapping, and its number in the schema.
struct GivenEntry {
  std::size_t number;      ///< in the schema
  const YamlEntry* entry;  ///< never null
};
/// The known entries of a mapping in the order of the file. Adds errors for unknown, missing and contradicting ones.
/// Adds an error and returns nothing if the value is not a mapping.
std::vector<GivenEntry> given_entries(const YamlNode& node, const Schema& schema, const Spot& spot,
                                      Diagnostics& diagnostics);
/// A value as a user types it, items of a list separated by commas.
std::string typed_text(const YamlNode& value);
/// Index of the alternative of a schema of kind any_of or variant that was found. Adds an error and returns nothing
/// if there is none.
std::optional<std::size_t> alternative_of(const YamlNode& node, const Schema& schema,
                                          const Spot& spot, Diagnostics& diagnostics);

/// A text that `parse` reads. A ValueError that it throws is reported as an error of the file.
template <typename T>
Shape<T> text_of(std::string text, std::string example, T (*parse)(std::string_view),
                 std::string (*print)(const T&)) {
  Shape<T> shape;
  shape.schema.kind = ValueKind::text;
  shape.schema.text = std::move(text);
  shape.schema.example = std::move(example);
  shape.read = [schema = kept(shape.schema), parse](T& into, const YamlNode& node, const Spot& spot,
                                                    Diagnostics& diagnostics) {
    return says_no_error(node, *schema, spot, diagnostics,
                         [&](const std::string& typed) { into = parse(typed); });
  };
  shape.write = [print](const T& value) { return scalar_node(print(value)); };
  return shape;
}

/// The same shape for a value of another type.
template <typename T, typename U>
Shape<T> shape_as(const Shape<U>& shape, std::function<T(U)> to, std::function<U(const T&)> from) {
  Shape<T> other;
  other.schema = shape.schema;
  other.read = [read = shape.read, to](T& into, const YamlNode& node, const Spot& spot,
                                       Diagnostics& diagnostics) {
    U value{};
    if (!read(value, node, spot, diagnostics)) return false;
    into = to(std::move(value));
    return true;
  };
  other.write = [write = shape.write, from](const T& value) { return write(from(value)); };
  return other;
}

/// One of several words for the values of an enumeration, in its order.
template <typename E>
Shape<E> word(std::string text, std::vector<std::string> words) {
  return shape_as<E, std::size_t>(
      choice(std::move(text), std::move(words)),
      [](std::size_t number) { return static_cast<E>(number); },
      [](const E& value) { return static_cast<std::size_t>(value); });
}

/// A list of `least` to `most` items of one shape.
template <typename T>
Shape<std::vector<T>> list(std::string text, Shape<T> item, std::size_t least = 1,
                           std::size_t most = static_cast<std::size_t>(-1)) {
  Shape<std::vector<T>> shape;
  shape.schema.kind = ValueKind::list;
  shape.schema.text = std::move(text);
  shape.schema.items.push_back(item.schema);
  shape.schema.min_items = least;
  shape.schema.max_items = most;
  shape.read = [schema = kept(shape.schema), read = item.read](
                   std::vector<T>& into, const YamlNode& node, const Spot& spot,
                   Diagnostics& diagnostics) {
    if (node.kind != YamlNode::Kind::list) {
      say_wrong_kind(node, *schema, spot, diagnostics);
      return false;
    }
    const bool counted = check_item_count(node, *schema, spot, diagnostics);
    into.clear();
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Spot place{spot.path + "[" + std::to_string(i) + "]", node.items[i].mark};
      T value{};
      if (read(value, node.items[i], place, diagnostics)) into.push_back(std::move(value));
    }
    return counted && into.size() == node.items.size();
  };
  shape.write = [write = item.write](const std::vector<T>& values) {
    YamlNode node;
    node.kind = YamlNode::Kind::list;
    for (const T& value : values) node.items.push_back(write(value));
    return node;
  };
  return shape;
}

/// One of several shapes, distinguished by their kind, or by the word in the entry `selector` if it is not empty.
/// @param which  index of the alternative that writes a value
template <typename T>
Shape<T> one_of(std::string text, std::vector<Shape<T>> alternatives,
                std::function<std::size_t(const T&)> which, std::string selector = {},
                std::vector<std::string> words = {}) {
  Shape<T> shape;
  shape.schema.kind = selector.empty() ? ValueKind::any_of : ValueKind::variant;
  shape.schema.text = std::move(text);
  shape.schema.selector = std::move(selector);
  shape.schema.words = std::move(words);
  for (const Shape<T>& one : alternatives) shape.schema.alternatives.push_back(one.schema);
  const auto ways = kept(std::move(alternatives));
  shape.read = [schema = kept(shape.schema), ways](T& into, const YamlNode& node, const Spot& spot,
                                                   Diagnostics& diagnostics) {
    const auto found = alternative_of(node, *schema, spot, diagnostics);
    return found && (*ways)[*found].read(into, node, spot, diagnostics);
  };
  shape.write = [ways, which](const T& value) { return (*ways)[which(value)].write(value); };
  return shape;
}

}  // namespace twum::studies
