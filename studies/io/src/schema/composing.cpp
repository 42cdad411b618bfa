// SPDX-License-Identifier: Apache-2.0
// What a value is made of: lists, alternatives, entries of mappings. Values are known by their addresses.
#include <twum/io/shape.hpp>

#include <algorithm>

namespace twum::inline v0_1::io {

ErasedShape erased_list_shape(std::string text, ErasedShape item, std::size_t least,
                              std::size_t most, const ErasedList& list) {
  ErasedShape shape;
  shape.schema.kind = ValueKind::list;
  shape.schema.text = std::move(text);
  shape.schema.items.push_back(std::move(item.schema));
  shape.schema.min_items = least;
  shape.schema.max_items = most;
  shape.read = [schema = kept(shape.schema), read = std::move(item.read), list](
                   void* into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    if (node.kind != YamlNode::Kind::list) {
      say_wrong_kind(node, *schema, spot, diagnostics);
      return false;
    }
    const bool counted = check_item_count(node, *schema, spot, diagnostics);
    list.clear(into);
    for (std::size_t i = 0; i < node.items.size(); ++i) {
      const Spot place{spot.path + "[" + std::to_string(i) + "]", node.items[i].mark};
      if (!read(list.add(into), node.items[i], place, diagnostics)) list.drop(into);
    }
    return counted && list.size(into) == node.items.size();
  };
  shape.write = [write = std::move(item.write), list](void* values) {
    YamlNode node;
    node.kind = YamlNode::Kind::list;
    for (std::size_t i = 0; i < list.size(values); ++i)
      node.items.push_back(write(list.item(values, i)));
    return node;
  };
  return shape;
}

ErasedShape erased_one_of(std::string text, std::vector<ErasedShape> alternatives,
                          std::function<std::size_t(void*)> which, std::string selector,
                          std::vector<std::string> words) {
  ErasedShape shape;
  shape.schema.kind = selector.empty() ? ValueKind::any_of : ValueKind::variant;
  shape.schema.text = std::move(text);
  shape.schema.selector = std::move(selector);
  shape.schema.words = std::move(words);
  for (const ErasedShape& one : alternatives) shape.schema.alternatives.push_back(one.schema);
  const auto ways = kept(std::move(alternatives));
  shape.read = [schema = kept(shape.schema), ways](void* into, const YamlNode& node,
                                                   const Spot& spot, Diagnostics& diagnostics) {
    const auto found = alternative_of(node, *schema, spot, diagnostics);
    return found && (*ways)[*found].read(into, node, spot, diagnostics);
  };
  shape.write = [ways, which = std::move(which)](void* value) {
    return (*ways)[which(value)].write(value);
  };
  return shape;
}

ErasedField erased_field(std::string name, ErasedShape shape, Reach reach) {
  ErasedField field;
  field.entry.name = std::move(name);
  field.entry.schema = std::move(shape.schema);
  field.entry.required = true;
  field.read = [read = std::move(shape.read), reach](void* into, const YamlNode& node,
                                                     const Spot& spot, Diagnostics& diagnostics) {
    return read(reach(into, Purpose::reading), node, spot, diagnostics);
  };
  field.write = [write = std::move(shape.write), reach](void* from) -> std::optional<YamlNode> {
    void* const value = reach(from, Purpose::writing);
    return value == nullptr ? std::nullopt : std::optional<YamlNode>(write(value));
  };
  return field;
}

ErasedField erased_selector(std::string name, std::string text, const std::string& value) {
  const ErasedShape shape = choice(std::move(text), {value}).erased();
  ErasedField field;
  field.entry.name = std::move(name);
  field.entry.schema = shape.schema;
  field.entry.required = true;
  field.read = [read = shape.read](void* /*into*/, const YamlNode& node, const Spot& spot,
                                   Diagnostics& diagnostics) {
    std::size_t ignored = 0;
    return read(&ignored, node, spot, diagnostics);
  };
  field.write = [value](void* /*from*/) -> std::optional<YamlNode> { return scalar_node(value); };
  return field;
}

namespace {

// The schema of a mapping with these fields.
Schema mapping_schema(std::string text, const std::vector<ErasedField>& fields, void* fresh) {
  Schema schema;
  schema.kind = ValueKind::mapping;
  schema.text = std::move(text);
  for (const ErasedField& field : fields) {
    SchemaEntry entry = field.entry;
    if (field.has_standard) {
      YamlNode value = *field.write(fresh);
      if (entry.fallback.empty()) entry.fallback = typed_text(value);
      entry.standards.push_back({std::move(value)});
    }
    schema.entries.push_back(std::move(entry));
  }
  return schema;
}

// Reads the entries of a mapping into a struct. Members whose entries are left out stay unchanged.
bool read_entries(void* into, const YamlNode& node, const Spot& spot, const Schema& schema,
                  const std::vector<ErasedField>& fields, const ErasedCheck& check,
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

// The entries of a struct as a mapping, without those that are left out.
YamlNode written_entries(void* from, const std::vector<ErasedField>& fields) {
  YamlNode node;
  node.kind = YamlNode::Kind::mapping;
  for (const ErasedField& field : fields)
    if (auto written = field.write(from))
      node.entries.push_back({field.entry.name, {}, std::move(*written)});
  return node;
}

}  // namespace

ErasedShape erased_mapping(std::string text, std::vector<ErasedField> fields, ErasedCheck check,
                           const Fresh& fresh) {
  ErasedShape shape;
  shape.schema = mapping_schema(std::move(text), fields, fresh.value);
  const auto parts = kept(std::move(fields));
  shape.read = [schema = kept(shape.schema), parts, check = std::move(check), copy = fresh.copy](
                   void* into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    copy(into);
    return read_entries(into, node, spot, *schema, *parts, check, diagnostics);
  };
  shape.write = [parts](void* value) { return written_entries(value, *parts); };
  return shape;
}

ErasedField erased_section(std::string name, std::string text, std::vector<ErasedField> fields,
                           ErasedCheck check, void* fresh) {
  ErasedField field;
  field.entry.name = std::move(name);
  field.entry.schema = mapping_schema(std::move(text), fields, fresh);
  field.entry.required = std::any_of(fields.begin(), fields.end(),
                                     [](const ErasedField& one) { return one.entry.required; });
  const auto parts = kept(std::move(fields));
  field.read = [schema = kept(field.entry.schema), parts, check = std::move(check)](
                   void* into, const YamlNode& node, const Spot& spot, Diagnostics& diagnostics) {
    return read_entries(into, node, spot, *schema, *parts, check, diagnostics);
  };
  field.write = [parts](void* value) {
    YamlNode node = written_entries(value, *parts);
    return node.entries.empty() ? std::nullopt : std::optional<YamlNode>(std::move(node));
  };
  return field;
}

}  // namespace twum::inline v0_1::io
