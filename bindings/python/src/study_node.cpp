// SPDX-License-Identifier: Apache-2.0
#include "study_node.hpp"

#include "conversions.hpp"

#include <twum/base/error.hpp>
#include <twum/io/number.hpp>
#include <twum/io/value_shape.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::python {
namespace {

using io::Schema;
using io::ValueKind;
using io::YamlNode;

const Schema& anything() {
  static const Schema schema;
  return schema;
}

const Schema& entry_of(const Schema& mapping, const std::string& name) {
  if (mapping.kind == ValueKind::named) return mapping.items.front();
  for (const io::SchemaEntry& entry : mapping.entries)
    if (entry.name == name || (entry.alias_counts && entry.alias == name)) return entry.schema;
  return anything();
}

bool is_mapping(const Schema& schema) {
  return schema.kind == ValueKind::mapping || schema.kind == ValueKind::named ||
         schema.kind == ValueKind::variant;
}

// The alternative for a value of Python: one that takes its kind, for a number a quantity if there is one.
const Schema& alternative_for(py::handle value, const Schema& schema) {
  const bool mapping = py::isinstance<py::dict>(value);
  const bool list = py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
  const Schema* found = nullptr;
  for (const Schema& one : schema.alternatives) {
    const bool fits = mapping ? is_mapping(one)
                      : list  ? one.kind == ValueKind::list
                              : !is_mapping(one) && one.kind != ValueKind::list;
    if (fits && (found == nullptr || one.kind == ValueKind::quantity)) found = &one;
  }
  return found == nullptr ? anything() : *found;
}

// The mapping that the word in the selecting entry names.
const Schema& selected(const py::dict& value, const Schema& schema) {
  const py::str selector(schema.selector);
  if (!value.contains(selector)) return anything();
  const std::string word = py::str(value[selector]);
  for (std::size_t i = 0; i < schema.words.size() && i < schema.alternatives.size(); ++i)
    if (schema.words[i] == word) return schema.alternatives[i];
  return anything();
}

YamlNode mapping_node(const std::string& path, const py::dict& value, const Schema& schema) {
  YamlNode node;
  node.kind = YamlNode::Kind::mapping;
  for (const auto& [key, entry] : value) {
    const std::string name =
        to_text(path.empty() ? "study: name of an entry" : path + ": name of an entry", key);
    const std::string place = path.empty() ? name : path + "." + name;
    node.entries.push_back({name, {}, to_node(place, entry, entry_of(schema, name))});
  }
  return node;
}

YamlNode list_node(const std::string& path, py::handle value, const Schema& schema) {
  YamlNode node;
  node.kind = YamlNode::Kind::list;
  const Schema& item = schema.kind == ValueKind::list ? schema.items.front() : anything();
  for (const py::handle one : value)
    node.items.push_back(to_node(path + "[" + std::to_string(node.items.size()) + "]", one, item));
  return node;
}

std::string number_text_of(const std::string& name, py::handle value, double number) {
  if (std::isnan(number)) throw InputError(name + ": nan is not a number");
  return PyLong_Check(value.ptr()) ? py::cast<std::string>(py::str(value))
                                   : io::number_text(number);
}

YamlNode scalar_of(const std::string& name, py::handle value, const Schema& schema) {
  if (PyUnicode_Check(value.ptr())) return io::scalar_node(to_text(name, value));
  if (PyBool_Check(value.ptr())) return io::scalar_node(py::cast<bool>(value) ? "true" : "false");
  if (py::hasattr(value, "__fspath__"))
    return io::scalar_node(to_text(name, value.attr("__fspath__")()));
  const auto number = number_of(value);
  if (!number)
    throw py::type_error(name +
                         ": expected a number, a text, a path, a list or a dictionary, not " +
                         py::cast<std::string>(py::type::of(value).attr("__name__")));
  const bool has_unit = schema.kind == ValueKind::quantity && schema.unit != "1";
  return io::scalar_node(number_text_of(name, value, *number) +
                         (has_unit ? " " + schema.unit : ""));
}

}  // namespace

YamlNode to_node(const std::string& path, py::handle value, const Schema& schema) {
  if (py::hasattr(value, "tolist")) return to_node(path, value.attr("tolist")(), schema);  // NumPy
  if (schema.kind == ValueKind::any_of) return to_node(path, value, alternative_for(value, schema));
  if (value.is_none()) return {};
  if (py::isinstance<py::dict>(value)) {
    const auto mapping = py::reinterpret_borrow<py::dict>(value);
    return mapping_node(path, mapping,
                        schema.kind == ValueKind::variant ? selected(mapping, schema) : schema);
  }
  if (py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value))
    return list_node(path, value, schema);
  return scalar_of(path, value, schema);
}

}  // namespace twum::inline v0_1::python
