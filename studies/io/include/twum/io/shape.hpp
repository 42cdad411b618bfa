// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/value_shape.hpp>

#include <algorithm>
#include <functional>
#include <initializer_list>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

namespace twum::inline v0_1::io {

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

/// Writes an entry of a struct; nothing if the entry is left out.
template <typename T>
using WriteEntry = FunctionOf<const T, std::optional<YamlNode>>;

/// One entry of a mapping, without the type of its struct.
struct ErasedField {
  SchemaEntry entry;                                    ///< name and what may stand there
  ErasedRead read;                                      ///< Field::read, by the struct's address
  std::function<std::optional<YamlNode>(void*)> write;  ///< Field::write, likewise
  bool has_standard{false};                             ///< as of Field
};

/// One entry of a mapping that is read into a struct, and the member that it sets.
template <typename T>
struct Field {
  SchemaEntry entry;    ///< name and what may stand there
  Read<T> read;         ///< sets the member
  WriteEntry<T> write;  ///< the member's value as a user types it
  /// if the entry is left out, the member keeps the value that it has in a new struct
  bool has_standard{false};

  /// The same without the type of its struct.
  ErasedField erased() const { return {entry, read.erased(), write.erased(), has_standard}; }
  /// The field that `erased` is, which has to be one of a T.
  static Field from(ErasedField erased) {
    return {std::move(erased.entry), Read<T>::from(std::move(erased.read)),
            WriteEntry<T>::from(std::move(erased.write)), erased.has_standard};
  }
};

/// The entries of a mapping that is read into a struct.
template <typename T>
class Fields {
 public:
  /// In the order of the file's templates.
  Fields(std::initializer_list<Field<T>> fields = {}) {
    for (const Field<T>& field : fields) push_back(field);
  }
  /// Adds a field, or several, at the end.
  /// @{
  void push_back(const Field<T>& field) { erased_.push_back(field.erased()); }
  void push_back(const Fields& others) {
    erased_.insert(erased_.end(), others.erased_.begin(), others.erased_.end());
  }
  /// @}
  /// Adds a field before that with the number `at`.
  void insert(std::size_t at, const Field<T>& field) {
    erased_.insert(erased_.begin() + static_cast<std::ptrdiff_t>(at), field.erased());
  }
  /// Whether there is an entry with this name.
  bool has(std::string_view name) const {
    return std::any_of(erased_.begin(), erased_.end(),
                       [&](const ErasedField& field) { return field.entry.name == name; });
  }
  /// The same without the type of their struct.
  const std::vector<ErasedField>& erased() const { return erased_; }

 private:
  std::vector<ErasedField> erased_;
};

/// What the address of a value is wanted for.
enum class Purpose : bool {
  reading,  ///< to set it: an optional is filled first
  writing   ///< to write it: null if the entry is left out
};
/// Gives the address of a field's value in a struct.
using Reach = std::function<void*(void* whole, Purpose purpose)>;

/// In a member of type V, or an optional V.
template <typename V, typename Target>
void* value_in(Target& member, Purpose purpose) {
  if constexpr (std::is_same_v<Target, V>) {
    return &member;
  } else {
    if (purpose == Purpose::reading) member = V{};
    return member.has_value() ? &*member : nullptr;
  }
}

/// The same if an empty list or text counts as left out.
template <typename V, typename Target>
void* value_unless_empty(Target& member, Purpose purpose) {
  if constexpr (requires { member.empty(); })
    if (purpose == Purpose::writing && member.empty()) return nullptr;
  return value_in<V>(member, purpose);
}

/// required() by the address of the struct.
ErasedField erased_field(std::string name, ErasedShape shape, Reach reach);

/// @name Fields of a struct
/// `member` is a pointer to the member, or a function from the struct to a reference to it.
/// @{
/// An entry that has to be there.
template <typename T, typename V, typename Member>
Field<T> required(std::string name, const Shape<V>& shape, Member member) {
  return Field<T>::from(
      erased_field(std::move(name), shape.erased(), [member](void* whole, Purpose purpose) {
        return value_in<V>(std::invoke(member, *static_cast<T*>(whole)), purpose);
      }));
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
  Field<T> field = Field<T>::from(
      erased_field(std::move(name), shape.erased(), [member](void* whole, Purpose purpose) {
        return value_unless_empty<V>(std::invoke(member, *static_cast<T*>(whole)), purpose);
      }));
  field.entry.required = false;
  field.entry.fallback = std::move(fallback);
  return field;
}

/// selector() without the type of its struct.
ErasedField erased_selector(std::string name, std::string text, const std::string& value);

/// An entry that says which of several mappings this is. It has no member.
template <typename T>
Field<T> selector(std::string name, std::string text, const std::string& value) {
  return Field<T>::from(erased_selector(std::move(name), std::move(text), value));
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
using Check = FunctionOf<T, bool, const Given&, Diagnostics&>;
/// Check<T>, for the address of a T.
using ErasedCheck = std::function<bool(void*, const Given&, Diagnostics&)>;

/// A new struct, in which what is left out has its default.
struct Fresh {
  void* value;                           ///< its address, while the mapping is made
  std::function<void(void* into)> copy;  ///< makes another struct equal to it
};

/// mapping() by the address of the struct.
ErasedShape erased_mapping(std::string text, std::vector<ErasedField> fields, ErasedCheck check,
                           const Fresh& fresh);
/// section() by the address of the struct.
ErasedField erased_section(std::string name, std::string text, std::vector<ErasedField> fields,
                           ErasedCheck check, void* fresh);

/// A mapping with fixed names that is read into a struct.
/// @param fresh  values of what is left out
template <typename T>
Shape<T> mapping(std::string text, const Fields<T>& fields, const Check<T>& check = {},
                 T fresh = {}) {
  return Shape<T>::from(
      erased_mapping(std::move(text), fields.erased(), check.erased(),
                     {&fresh, [fresh](void* into) { *static_cast<T*>(into) = fresh; }}));
}

/// A nested mapping whose entries set members of the same struct. It is required if one of its entries is.
template <typename T>
Field<T> section(std::string name, std::string text, const Fields<T>& fields,
                 const Check<T>& check = {}) {
  T fresh{};
  return Field<T>::from(
      erased_section(std::move(name), std::move(text), fields.erased(), check.erased(), &fresh));
}

}  // namespace twum::inline v0_1::io
