// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/value_shape.hpp>

#include <functional>
#include <string>
#include <utility>
#include <vector>

/// Mappings whose keys are names of the user's; internal.
namespace twum::inline v0_1::studies::shapes {

/// What else is asked of an entry. Adds diagnostics and returns false if something is wrong.
using EntryCheck = std::function<bool(const YamlEntry&, const Spot&, Diagnostics&)>;

/// A mapping with at least one entry, each a name and a value of this shape; `name` is where an item has its name.
/// @param schema  text and examples
template <typename T>
Shape<std::vector<T>> named_items(Schema schema, const Shape<T>& item, std::string T::*name,
                                  const EntryCheck& check = {}) {
  Shape<std::vector<T>> shape;
  shape.schema = std::move(schema);
  shape.schema.kind = ValueKind::named;
  shape.schema.items.push_back(item.schema);
  shape.read = [schema = kept(shape.schema), item, name, check](
                   std::vector<T>& into, const YamlNode& node, const Spot& spot,
                   Diagnostics& diagnostics) {
    into.clear();
    if (node.kind != YamlNode::Kind::mapping || node.entries.empty()) {
      say_wrong_kind(node, *schema, spot, diagnostics);
      return false;
    }
    bool good = true;
    for (const YamlEntry& entry : node.entries) {
      T one;
      good = (!check || check(entry, spot, diagnostics)) && good;
      good =
          item.read(one, entry.value, spot.entry(entry.key, entry.key_mark), diagnostics) && good;
      one.*name = entry.key;
      into.push_back(std::move(one));
    }
    return good;
  };
  shape.write = [item, name](const std::vector<T>& items) {
    YamlNode node;
    node.kind = YamlNode::Kind::mapping;
    for (const T& one : items) node.entries.push_back({one.*name, {}, item.write(one)});
    return node;
  };
  return shape;
}

}  // namespace twum::inline v0_1::studies::shapes
