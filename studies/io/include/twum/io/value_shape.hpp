// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/diagnostics.hpp>
#include <twum/io/erased.hpp>
#include <twum/io/schema.hpp>
#include <twum/io/yaml_node.hpp>

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

namespace twum::inline v0_1::io {

/// Place of a value in a file.
struct Spot {
  std::string path;  ///< such as "study.variables.preload.min"
  SourceMark mark;   ///< its key, where errors point if it has no value

  /// The place of an entry of the mapping at this place.
  Spot entry(const std::string& name, SourceMark key) const {
    return {path.empty() ? name : path + "." + name, key};
  }
};

/// Sets the value, or as much of it as can be read. If something is wrong, adds diagnostics and returns false.
template <typename T>
using Read = FunctionOf<T, bool, const YamlNode&, const Spot&, Diagnostics&>;
/// The value as a user types it; reading gives back the same value.
template <typename T>
using Write = FunctionOf<const T, YamlNode>;

/// Read<T>, for the address of a T.
using ErasedRead = std::function<bool(void*, const YamlNode&, const Spot&, Diagnostics&)>;
/// Write<T>, for the address of a T.
using ErasedWrite = std::function<YamlNode(void*)>;

/// How a value is represented in a file, without the value's type.
struct ErasedShape {
  Schema schema;      ///< what may stand there
  ErasedRead read;    ///< from a file
  ErasedWrite write;  ///< to a file
};

/// How a value of one type is represented in a file: admissible values, reading and writing. From one shape follow
/// errors with places, defaults, JSON Schema, templates and reference pages.
template <typename T>
struct Shape {
  Schema schema;   ///< what may stand there
  Read<T> read;    ///< from a file
  Write<T> write;  ///< to a file

  /// The same without the type of its value.
  ErasedShape erased() const { return {schema, read.erased(), write.erased()}; }
  /// The shape that `erased` is, which has to be one of a T.
  static Shape from(ErasedShape erased) {
    return {std::move(erased.schema), Read<T>::from(std::move(erased.read)),
            Write<T>::from(std::move(erased.write))};
  }
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
template <typename T, typename U, typename To, typename From>
Shape<T> shape_as(const Shape<U>& shape, To to, From from) {
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

/// The same with the words of to_string(); the values are those of the enumeration, from the first on.
template <typename E>
requires std::is_enum_v<E> Shape<E> word(std::string text, std::initializer_list<E> values) {
  std::vector<std::string> words;
  for (const E value : values) words.emplace_back(to_string(value));
  return word<E>(std::move(text), std::move(words));
}

/// list() by the address of the list.
ErasedShape erased_list_shape(std::string text, ErasedShape item, std::size_t least,
                              std::size_t most, const ErasedList& list);

/// A list of `least` to `most` items of one shape.
template <typename T>
Shape<std::vector<T>> list(std::string text, const Shape<T>& item, std::size_t least = 1,
                           std::size_t most = static_cast<std::size_t>(-1)) {
  return Shape<std::vector<T>>::from(
      erased_list_shape(std::move(text), item.erased(), least, most, erased_list<T>()));
}

/// one_of() by the address of the value.
ErasedShape erased_one_of(std::string text, std::vector<ErasedShape> alternatives,
                          std::function<std::size_t(void*)> which, std::string selector,
                          std::vector<std::string> words);

/// One of several shapes, distinguished by their kind, or by the word in the entry `selector` if it is not empty.
/// @param which  index of the alternative that writes a value
template <typename T>
Shape<T> one_of(std::string text, const std::vector<Shape<T>>& alternatives,
                const FunctionOf<const T, std::size_t>& which, std::string selector = {},
                std::vector<std::string> words = {}) {
  std::vector<ErasedShape> ways;
  for (const Shape<T>& one : alternatives) ways.push_back(one.erased());
  return Shape<T>::from(erased_one_of(std::move(text), std::move(ways), which.erased(),
                                      std::move(selector), std::move(words)));
}

}  // namespace twum::inline v0_1::io
