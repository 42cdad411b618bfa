// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/schema/shape.hpp>
#include <twum/studies/yaml/node.hpp>

namespace twum::studies {

/// Adds everything in which a tree departs from a schema: unknown, missing and contradicting entries,
/// wrong kinds, wrong units, values out of range. Never throws for what the tree holds.
/// @{
void validate(const YamlNode& root, const Schema& schema, Diagnostics& diagnostics);
void validate(const YamlNode& node, const Schema& schema, const Spot& spot,
              Diagnostics& diagnostics);
/// @}

/// The value of a quantity in SI; nothing if it is not valid by its schema. Never throws.
std::optional<double> quantity_of(const YamlNode& node, const Schema& schema);

/// The node at a path such as "motor.stator.frequency"; null if there is none.
const YamlNode* find_path(const YamlNode& root, std::string_view path);

/// The entry of a schema at such a path; null if there is none.
const SchemaEntry* find_path(const Schema& root, std::string_view path);

}  // namespace twum::studies
