// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "parts.hpp"

#include <twum/io/schema.hpp>
#include <twum/io/yaml_node.hpp>

namespace twum::python {

/// What stands in a study file for a dictionary, list, number or text of Python. A number in place of a quantity is in its SI
/// unit.
/// @throws TypeError for anything else
io::YamlNode to_node(py::handle value, const io::Schema& schema);

}  // namespace twum::python
