// SPDX-License-Identifier: Apache-2.0
#include "schema/scalar_checks.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::io {
namespace {

std::string limit_text(double limit, const Schema& schema) {
  if (schema.kind == ValueKind::count) return std::to_string(static_cast<long long>(limit));
  // Zero keeps its unit, and other limits are round numbers.
  return limit == 0 && schema.unit != "1" ? "0 " + schema.unit
                                          : engineering(limit, schema.unit, 10);
}

std::string such_as(const Schema& schema) {
  return schema.example.empty() ? "" : " such as '" + schema.example + "'";
}

std::string comma_such_as(const Schema& schema) {
  return schema.example.empty() ? "" : "," + such_as(schema);
}

void check_word(std::string_view text, const Schema& schema) {
  std::vector<std::string_view> choices(schema.words.begin(), schema.words.end());
  for (const std::string_view choice : choices) {
    if (choice == text) return;
  }
  throw ValueError(quoted(text) + " is not known here",
                   choices.size() == 1 ? expectation(schema) : did_you_mean(text, choices));
}

void check_text(std::string_view text, const Schema& schema) {
  if (text.empty()) throw ValueError("empty", expectation(schema));
  if (schema.check != nullptr) schema.check(text);
}

// The first line of the sample, such as ", as in 'preload: {min: 60 N, max: 300 N}'".
std::string sample_line(const Schema& schema) {
  if (schema.sample.empty()) return {};
  return ", as in '" + schema.sample.substr(0, schema.sample.find('\n')) + "'";
}

std::string alternatives_text(const Schema& schema) {
  std::string text;
  for (const Schema& one : schema.alternatives) {
    const std::string each = expectation(one);
    text += text.empty() ? each : " or " + each.substr(std::string_view("expected ").size());
  }
  return text;
}

}  // namespace

void check_size(double value, std::string_view text, const Schema& schema) {
  if (schema.min_excluded ? !(value > schema.min) : !(value >= schema.min)) {
    throw ValueError(quoted(text) + " is too small",
                     (schema.min_excluded ? "must be more than " : "must be at least ") +
                         limit_text(schema.min, schema) + comma_such_as(schema));
  }
  if (schema.max_excluded ? !(value < schema.max) : !(value <= schema.max)) {
    throw ValueError(quoted(text) + " is too large",
                     (schema.max_excluded ? "must be less than " : "must be at most ") +
                         limit_text(schema.max, schema) + comma_such_as(schema));
  }
  if ((schema.whole || schema.kind == ValueKind::count) && value != std::floor(value)) {
    throw ValueError(quoted(text) + " is not a whole number", expectation(schema));
  }
}

double parse_number_of(std::string_view text, const Schema& schema) {
  const bool count = schema.kind == ValueKind::count;
  return parse_quantity(text, Expected{count ? "1" : schema.unit, schema.example, schema.absolute});
}

double read_number(std::string_view text, const Schema& schema) {
  const double value = parse_number_of(text, schema);
  check_size(value, text, schema);
  return value;
}

void check_scalar(std::string_view text, const Schema& schema) {
  switch (schema.kind) {
    case ValueKind::quantity:
    case ValueKind::count: read_number(text, schema); break;
    case ValueKind::word: check_word(text, schema); break;
    default: check_text(text, schema); break;
  }
}

bool by_parameter(const Schema& schema) {
  return schema.kind == ValueKind::mapping && !schema.entries.empty() &&
         std::all_of(schema.entries.begin(), schema.entries.end(),
                     [](const SchemaEntry& entry) { return entry.alias_counts; });
}

std::string expectation(const Schema& schema) {
  std::string text = "expected ";
  switch (schema.kind) {
    case ValueKind::quantity:
      text += schema.whole ? "a whole number" : dimension_phrase(schema.unit);
      break;
    case ValueKind::count: text += "a whole number"; break;
    case ValueKind::text: text += "a text"; break;
    case ValueKind::word:
      text += schema.words.size() == 1 ? "" : "one of ";
      for (const std::string& word : schema.words)
        text += (&word == schema.words.data() ? "" : ", ") + word;
      return text;
    case ValueKind::mapping:
      if (by_parameter(schema)) return "expected a mapping of parameters" + sample_line(schema);
      text += "a mapping with";
      for (const SchemaEntry& entry : schema.entries) {
        text += (&entry == schema.entries.data() ? " " : ", ") + entry.name;
      }
      return text;
    case ValueKind::named: return "expected a mapping such as '" + schema.example + "'";
    case ValueKind::list:
      return "expected a list, each item " +
             expectation(schema.items.front()).substr(std::string_view("expected ").size());
    case ValueKind::any_of: return alternatives_text(schema);
    case ValueKind::variant:
      text += "a mapping with " + schema.selector + ": ";
      for (const std::string& word : schema.words) {
        text += (&word == schema.words.data() ? "" : ", ") + word;
      }
      return text;
  }
  return text + such_as(schema);
}

}  // namespace twum::inline v0_1::io
