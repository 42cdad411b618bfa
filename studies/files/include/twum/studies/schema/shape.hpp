// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/schema/value_shape.hpp>

#include <algorithm>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace twum::studies {

/// A mapping of a file, for checks that involve several of its entries.
class Given {
 public:
  /// @param right  values that were read successfully, by position of the entry in the schema; null for the others
  Given(const YamlNode& node, const Spot& spot, const Schema& schema,
        std::vector<const YamlNode*> right)
      : node_(node), spot_(spot), schema_(schema), right_(std::move(right)) {}

  /// The value of an entry, whether valid or not; null if the entry is left out.
  const YamlNode* find(std::string_view name) const { return node_.find(name); }
  /// The value of an entry if it is valid; null if the entry is left out or wrong.
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

/// One entry of a mapping that is read into a struct, and the member that it sets.
template <typename T>
struct Field {
  SchemaEntry entry;  ///< name and what may stand there
  /// Sets the member; false if the value is wrong.
  std::function<bool(T&, const YamlNode&, const Spot&, Diagnostics&)> read;
  /// The member's value as a user types it; nothing if the entry is left out.
  std::function<std::optional<YamlNode>(const T&)> write;
  /// if the entry is left out, the member keeps the value that it has in a new struct
  bool has_standard{false};
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

/// An entry whose default is the value in a new struct.
template <typename T, typename V, typename Member>
Field<T> standard(std::string name, const Shape<V>& shape, Member member) {
  Field<T> field = required<T>(std::move(name), shape, member);
  field.entry.required = false;
  field.has_standard = true;
  return field;
}

/// An entry that may be left out. Its member is then empty (an optional, a list, a text).
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

/// An entry that says which of several mappings this is. It has no member.
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

/// The same field, commented out in templates.
template <typename T>
Field<T> hidden(Field<T> field) {
  field.entry.shown = false;
  return field;
}
/// @}

/// Checks several entries of a mapping together, as far as they could be read. Adds diagnostics and returns false if
/// something is wrong.
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

/// Reads the entries of a mapping into a struct. Members whose entries are left out stay unchanged.
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

/// The entries of a struct as a mapping, without those that are left out.
template <typename T>
YamlNode written_entries(const T& from, const std::vector<Field<T>>& fields) {
  YamlNode node;
  node.kind = YamlNode::Kind::mapping;
  for (const Field<T>& field : fields)
    if (auto written = field.write(from))
      node.entries.push_back({field.entry.name, {}, std::move(*written)});
  return node;
}

/// A mapping with fixed names that is read into a struct.
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

/// A nested mapping whose entries set members of the same struct. It is required if one of its entries is.
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
