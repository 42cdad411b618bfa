// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/schema.hpp>

#include <string>
#include <string_view>

namespace twum::inline v0_1::io {

/// A schema as JSON Schema (draft 2020-12), for editors and other programs. Depends on the schema only.
/// @param id  address that identifies the schema
std::string json_schema(const Schema& schema, std::string_view title, std::string_view id);

/// The entries of a mapping and of the mappings in it as a Markdown table: path, admissible values, default, meaning.
std::string markdown_table(const Schema& mapping);

/// A commented YAML file to start from: every entry with its example, optional ones commented out.
std::string yaml_template(const Schema& schema, std::string_view heading);

}  // namespace twum::inline v0_1::io
