// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/design/parameters.hpp>
#include <twum/studies/schema/schema.hpp>

#include <string>
#include <vector>

/// Pieces that the tables of the study file are put together from; internal.
namespace twum::studies::shapes {

SchemaEntry needed(std::string name, Schema schema);
/// @param fallback  what holds if it is left out, in words
SchemaEntry optional(std::string name, Schema schema, std::string fallback);
/// Commented out in a file to start from.
SchemaEntry hidden(SchemaEntry entry);
/// One of a pair of which exactly one is needed, and the other of the pair.
SchemaEntry either(std::string name, Schema schema, std::string other);
SchemaEntry instead(std::string name, Schema schema, std::string other);

Schema mapping(std::string text, std::vector<SchemaEntry> entries);
Schema list(std::string text, Schema item);
Schema quantity(std::string text, std::string unit, std::string example);
Schema count(std::string text, std::string example, double least, double most);
Schema fraction(std::string text, std::string example);  ///< between 0 and 1, ends excluded
Schema word(std::string text, std::vector<std::string> words);
Schema path(std::string text, std::string example);
Schema metric(std::string text);
Schema metrics();      ///< list of metric expressions
Schema constraints();  ///< list of limits
/// A name, or a mapping of options; `evaluations` holds if max_evaluations is left out.
Schema solver(const char* evaluations = "20000");
Schema samples();
Schema seed();
Schema folder();  ///< result directory of another study

/// A mapping from parameters (by name or symbol) to something whose shape depends on the parameter.
/// @param sample  lines for a file to start from
Schema by_parameter(Schema (*shape)(const ParameterInfo&), std::string text, std::string sample);

Schema value_of(const ParameterInfo& parameter);   ///< one value
Schema values_of(const ParameterInfo& parameter);  ///< a list of values
Schema range(const ParameterInfo& parameter);      ///< {min, max, scale}
Schema sweep_range(
    const ParameterInfo& parameter);  ///< {min, max, points, scale}, or a list of values
Schema distribution(const ParameterInfo& parameter);  ///< {distribution, ...}

}  // namespace twum::studies::shapes
