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

/// Where a value stands in a file.
struct Spot {
  std::string path;  ///< such as "study.variables.preload.min"
  SourceMark mark;   ///< where to point if nothing stands there: its key

  /// The spot of an entry of the mapping that stands here.
  Spot entry(const std::string& name, SourceMark key) const {
    return {path.empty() ? name : path + "." + name, key};
  }
};

/// How a value of one type stands in a file: what may stand there, how it is read and how it is
/// written. One shape gives errors with places, defaults, JSON Schema, templates and reference pages.
template <typename T>
struct Shape {
  Schema schema;  ///< what may stand there
  /// Sets the value, or as much of it as can be read; false if something is wrong, which is said.
  std::function<bool(T&, const YamlNode&, const Spot&, Diagnostics&)> read;
  /// What one would type for a value; read() gives the same value for it.
  std::function<YamlNode(const T&)> write;
};

/// @name Values of one word or number
/// @{
/// A text as a node of YAML.
YamlNode scalar_node(std::string text);
/// A number as a schema of kind quantity or count wants it, in SI.
Shape<double> number(Schema schema);
/// A number with a unit of this dimension, in SI.
Shape<double> quantity(std::string text, std::string unit, std::string example);
/// A number between 0 and 1, ends excluded.
Shape<double> fraction(std::string text, std::string example);
/// A whole number from `least` to `most`.
Shape<std::uint64_t> count(std::string text, std::string example, double least, double most);
/// Any text, as typed.
Shape<std::string> path(std::string text, std::string example);
/// One of some words; the value is the number of the word.
Shape<std::size_t> choice(std::string text, std::vector<std::string> words);
/// @}

/// A value that the copies of a function share.
template <typename V>
std::shared_ptr<const V> kept(V value) {
  return std::make_shared<const V>(std::move(value));
}

/// Says that something else stands where the schema wants something.
void say_wrong_kind(const YamlNode& node, const Schema& schema, const Spot& spot,
                    Diagnostics& diagnostics);
/// Runs a reader of a text; nothing if it throws a ValueError, which is said.
bool says_no_error(const YamlNode& node, const Schema& schema, const Spot& spot,
                   Diagnostics& diagnostics, const std::function<void(const std::string&)>& use);
/// False if the number of items is wrong, which is said.
bool check_item_count(const YamlNode& list, const Schema& schema, const Spot& spot,
                      Diagnostics& diagnostics);
/// An entry of a mapping, and its number in the schema.
struct GivenEntry {
  std::size_t number;      ///< in the schema
  const YamlEntry* entry;  ///< never null
};
/// The known entries of a mapping in the order of the file; unknown, missing and contradicting ones are
/// said. Empty if no mapping stands there, which is said too.
std::vector<GivenEntry> given_entries(const YamlNode& node, const Schema& schema, const Spot& spot,
                                      Diagnostics& diagnostics);
/// A value as one would type it, items of a list between commas.
std::string typed_text(const YamlNode& value);
/// Which alternative of a schema of kind any_of or variant stands there; nothing if none, which is said.
std::optional<std::size_t> alternative_of(const YamlNode& node, const Schema& schema,
                                          const Spot& spot, Diagnostics& diagnostics);

/// A text that `parse` reads; a ValueError of it is an error of the file.
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

/// One of some words that stand for the values of an enumeration, in its order.
template <typename E>
Shape<E> word(std::string text, std::vector<std::string> words) {
  return shape_as<E, std::size_t>(
      choice(std::move(text), std::move(words)),
      [](std::size_t number) { return static_cast<E>(number); },
      [](const E& value) { return static_cast<std::size_t>(value); });
}

/// Any number of the same, at least one.
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

/// One of several shapes, told apart by their kind, or by the word in an entry if `selector` names one.
/// @param which  number of the alternative that writes a value
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

/// A mapping as it stands in a file, for checks that look at several of its entries.
class Given {
 public:
  /// @param right  what has been read, by the place of the entry in the schema; null otherwise
  Given(const YamlNode& node, const Spot& spot, const Schema& schema,
        std::vector<const YamlNode*> right)
      : node_(node), spot_(spot), schema_(schema), right_(std::move(right)) {}

  /// What stands for an entry, right or wrong; null if it is left out.
  const YamlNode* find(std::string_view name) const { return node_.find(name); }
  /// What stands for an entry, if it has been read; null if it is left out or wrong.
  const YamlNode* right(std::string_view name) const {
    for (std::size_t i = 0; i < right_.size(); ++i)
      if (schema_.entries[i].name == name) return right_[i];
    return nullptr;
  }
  /// The mapping itself.
  const YamlNode& node() const { return node_; }
  /// The path of an entry.
  std::string path(const std::string& name) const { return spot_.entry(name, {}).path; }
  /// Its own path.
  const std::string& path() const { return spot_.path; }

 private:
  const YamlNode& node_;
  const Spot& spot_;
  const Schema& schema_;
  std::vector<const YamlNode*> right_;
};

/// One entry of a mapping that becomes a struct, and the member it is for.
template <typename T>
struct Field {
  SchemaEntry entry;  ///< name and what may stand there
  /// Sets the member; false if what stands there is wrong.
  std::function<bool(T&, const YamlNode&, const Spot&, Diagnostics&)> read;
  /// What one would type for the member; nothing if it is left out.
  std::function<std::optional<YamlNode>(const T&)> write;
  bool has_standard{false};  ///< left out, the member keeps its value in a fresh struct
};

/// @name Fields of a struct
/// `member` is a pointer to the member, or a function from the struct to a reference to it.
/// @{
/// An entry that has to be there.
template <typename T, typename V, typename Member>
Field<T> required(std::string name, const Shape<V>& shape, Member member) {
  Field<T> field;
  field.entry.name = std::move(name);
  field.entry.schema = shape.schema;
  field.entry.required = true;
  field.read = [read = shape.read, member](T& into, const YamlNode& node, const Spot& spot,
                                           Diagnostics& diagnostics) {
    auto& target = std::invoke(member, into);
    if constexpr (std::is_same_v<std::remove_reference_t<decltype(target)>, V>) {
      return read(target, node, spot, diagnostics);
    } else {
      V value{};
      const bool right = read(value, node, spot, diagnostics);
      target = std::move(value);
      return right;
    }
  };
  field.write = [write = shape.write, member](const T& from) -> std::optional<YamlNode> {
    const auto& value = std::invoke(member, from);
    if constexpr (requires { value.has_value(); })
      return value.has_value() ? std::optional<YamlNode>(write(*value)) : std::nullopt;
    else
      return write(value);
  };
  return field;
}

/// An entry whose value, if it is left out, is that of a fresh struct.
template <typename T, typename V, typename Member>
Field<T> standard(std::string name, const Shape<V>& shape, Member member) {
  Field<T> field = required<T>(std::move(name), shape, member);
  field.entry.required = false;
  field.has_standard = true;
  return field;
}

/// An entry that may be left out, for a member that is empty then (an optional, a list, a text).
/// @param fallback  what holds then, in words
template <typename T, typename V, typename Member>
Field<T> optional(std::string name, const Shape<V>& shape, Member member, std::string fallback) {
  Field<T> field = required<T>(std::move(name), shape, member);
  field.entry.required = false;
  field.entry.fallback = std::move(fallback);
  field.write = [write = field.write, member](const T& from) {
    const auto& value = std::invoke(member, from);
    if constexpr (requires { value.empty(); }) {
      if (value.empty()) return std::optional<YamlNode>();
    }
    return write(from);
  };
  return field;
}

/// An entry that says which of several mappings this is; no member holds it.
template <typename T>
Field<T> selector(std::string name, std::string text, const std::string& value) {
  Field<T> field;
  const Shape<std::size_t> shape = choice(std::move(text), {value});
  field.entry.name = std::move(name);
  field.entry.schema = shape.schema;
  field.entry.required = true;
  field.read = [read = shape.read](T&, const YamlNode& node, const Spot& spot,
                                   Diagnostics& diagnostics) {
    std::size_t ignored = 0;
    return read(ignored, node, spot, diagnostics);
  };
  field.write = [write = shape.write](const T&) -> std::optional<YamlNode> { return write(0); };
  return field;
}

/// Commented out in a file to start from.
template <typename T>
Field<T> hidden(Field<T> field) {
  field.entry.shown = false;
  return field;
}
/// @}

/// Says what only a look at several entries of a mapping shows, on whatever could be read; false if something is wrong.
template <typename T>
using Check = std::function<bool(T&, const Given&, Diagnostics&)>;

/// The schema of a mapping with these fields.
/// @param fresh  values of what is left out
template <typename T>
Schema mapping_schema(std::string text, std::vector<Field<T>>& fields, const T& fresh) {
  Schema schema;
  schema.kind = ValueKind::mapping;
  schema.text = std::move(text);
  for (Field<T>& field : fields) {
    if (field.has_standard) {
      YamlNode value = *field.write(fresh);
      if (field.entry.fallback.empty()) field.entry.fallback = typed_text(value);
      field.entry.standards.push_back({std::move(value)});
    }
    schema.entries.push_back(field.entry);
  }
  return schema;
}

/// Reads the entries of a mapping into a struct that keeps what is left out.
template <typename T>
bool read_entries(T& into, const YamlNode& node, const Spot& spot, const Schema& schema,
                  const std::vector<Field<T>>& fields, const Check<T>& check,
                  Diagnostics& diagnostics) {
  if (node.kind != YamlNode::Kind::mapping) {
    say_wrong_kind(node, schema, spot, diagnostics);
    return false;
  }
  std::vector<const YamlNode*> right(fields.size(), nullptr);
  const std::size_t said = diagnostics.count();
  const std::vector<GivenEntry> given = given_entries(node, schema, spot, diagnostics);
  bool good = diagnostics.count() == said;
  for (const auto& [number, entry] : given) {
    const Spot place = spot.entry(entry->key, entry->key_mark);
    if (fields[number].read(into, entry->value, place, diagnostics))
      right[number] = &entry->value;
    else
      good = false;
  }
  return (!check || check(into, Given(node, spot, schema, right), diagnostics)) && good;
}

/// The entries of a struct as a mapping; what is left out is not there.
template <typename T>
YamlNode written_entries(const T& from, const std::vector<Field<T>>& fields) {
  YamlNode node;
  node.kind = YamlNode::Kind::mapping;
  for (const Field<T>& field : fields)
    if (auto written = field.write(from))
      node.entries.push_back({field.entry.name, {}, std::move(*written)});
  return node;
}

/// Entries with fixed names that become a struct.
/// @param fresh  values of what is left out
template <typename T>
Shape<T> mapping(std::string text, std::vector<Field<T>> fields, Check<T> check = {},
                 T fresh = {}) {
  Shape<T> shape;
  shape.schema = mapping_schema(std::move(text), fields, fresh);
  const auto parts = kept(std::move(fields));
  shape.read = [schema = kept(shape.schema), parts, check, fresh](
                   T& into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    into = fresh;
    return read_entries(into, node, spot, *schema, *parts, check, diagnostics);
  };
  shape.write = [parts](const T& value) { return written_entries(value, *parts); };
  return shape;
}

/// A mapping inside that of a struct whose entries are members of the same struct. It has to be there if one of its entries
/// has to.
template <typename T>
Field<T> section(std::string name, std::string text, std::vector<Field<T>> fields,
                 Check<T> check = {}) {
  Field<T> field;
  field.entry.name = std::move(name);
  field.entry.schema = mapping_schema(std::move(text), fields, T{});
  field.entry.required = std::any_of(fields.begin(), fields.end(),
                                     [](const Field<T>& one) { return one.entry.required; });
  const auto parts = kept(std::move(fields));
  field.read = [schema = kept(field.entry.schema), parts, check](
                   T& into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    return read_entries(into, node, spot, *schema, *parts, check, diagnostics);
  };
  field.write = [parts](const T& value) {
    YamlNode node = written_entries(value, *parts);
    return node.entries.empty() ? std::nullopt : std::optional<YamlNode>(std::move(node));
  };
  return field;
}

}  // namespace twum::studies
