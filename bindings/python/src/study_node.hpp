// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <twum/io/schema.hpp>
#include <twum/io/yaml_node.hpp>

#include <string>

namespace twum::inline v0_1::python {

/// What stands in a study file for a dictionary, list, number, path or text of Python. A number in place of a quantity is in
/// its SI unit.
/// @param path  the entry, such as "study.variables"; empty for the whole file
/// @throws TypeError for anything else, InputError for NaN, both naming the entry
io::YamlNode to_node(const std::string& path, py::handle value, const io::Schema& schema);

}  // namespace twum::inline v0_1::python
