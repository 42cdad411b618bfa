// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/schema/schema.hpp>

#include <string>
#include <string_view>

namespace twum::studies {

/// A schema as JSON Schema (draft 2020-12), for editors and other programs: a function of the table alone.
/// @param id  address that names it
std::string json_schema(const Schema& schema, std::string_view title, std::string_view id);

/// The entries of a mapping, and those within them, as a Markdown table: path, what may stand there,
/// what holds if it is left out, what it is.
std::string markdown_table(const Schema& mapping);

/// A commented YAML file to start from: every entry with its example, optional ones commented out.
std::string yaml_template(const Schema& schema, std::string_view heading);

}  // namespace twum::studies
