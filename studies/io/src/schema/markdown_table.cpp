// SPDX-License-Identifier: Apache-2.0
#include <twum/io/publish.hpp>

#include "schema/scalar_checks.hpp"

#include <twum/io/number.hpp>
#include <twum/io/units.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

std::string range_text(const Schema& schema) {
  const bool low = std::isfinite(schema.min);
  const bool high = std::isfinite(schema.max);
  const auto number = [](double value) {
    return std::abs(value) < 1e16 && value == std::floor(value)
               ? std::to_string(static_cast<long long>(value))
               : rounded_text(value, 6);
  };
  if (schema.min_excluded && schema.max_excluded)
    return "between " + number(schema.min) + " and " + number(schema.max);
  if (low && high) {
    return (schema.min_excluded ? "more than " : "") + number(schema.min) + " to " +
           number(schema.max);
  }
  if (low) return (schema.min_excluded ? "more than " : "at least ") + number(schema.min);
  return high ? "at most " + number(schema.max) : "";
}

std::string with_range(const std::string& text, const Schema& schema) {
  const std::string range = range_text(schema);
  return range.empty() ? text : text + ", " + range;
}

std::string words_text(const Schema& schema) {
  std::string text;
  for (const std::string& word : schema.words) text += (text.empty() ? "`" : ", `") + word + "`";
  return text;
}

// Escapes bars, which end a cell.
std::string cell(const std::string& text) {
  std::string out;
  for (const char c : text) out += c == '|' ? std::string("\\|") : std::string(1, c);
  return out;
}

// One row for each entry, those within it below it.
class TableWriter {
 public:
  std::string take() { return std::move(text_); }

  void entries(const Schema& mapping, const std::string& path, const std::string& when) {
    for (const SchemaEntry& entry : mapping.entries) one(entry, path + entry.name, when);
  }

 private:
  void one(const SchemaEntry& entry, const std::string& path, const std::string& when) {
    std::string default_text = entry.required ? "required" : entry.fallback;
    if (!entry.alternative_entry.empty() && !in_parameter_) {
      default_text = entry.required ? "required, or `" + entry.alternative_entry + "`"
                                    : "instead of `" + entry.alternative_entry + "`";
    }
    if (!entry.spared_by.empty() && entry.required)
      default_text +=
          (entry.alternative_entry.empty() ? ", or `" : " or `") + entry.spared_by + "`";
    const std::string text = (when.empty() ? "" : "`" + when + "`: ") + entry.schema.text;
    text_ += "| `" + path + "` | " + cell(value(entry.schema)) + " | " + default_text + " | " +
             cell(text) + " |\n";
    // Options of single solvers have a page of their own.
    if (entry.name != "options") inside(entry.schema, path, when);
  }

  // What may stand there.
  std::string value(const Schema& schema) const {
    switch (schema.kind) {
      case ValueKind::quantity: return quantity(schema);
      case ValueKind::count: return with_range("whole number", schema);
      case ValueKind::word: return words_text(schema);
      case ValueKind::mapping: return by_parameter(schema) ? "by parameter" : "mapping";
      case ValueKind::named: return "by name: " + value(schema.items.front());
      case ValueKind::list: return "list: " + value(schema.items.front());
      case ValueKind::variant: return "mapping, by `" + schema.selector + "`";
      case ValueKind::any_of: return alternatives(schema);
      case ValueKind::text: break;
    }
    return schema.example.empty() ? "text" : "`" + schema.example + "`";
  }

  std::string quantity(const Schema& schema) const {
    if (in_parameter_) return "value of the parameter";
    if (schema.unit == "1") return with_range("number", schema);
    return dimension_phrase(schema.unit) + ", `" + schema.example + "`";
  }

  std::string alternatives(const Schema& schema) const {
    std::string text;
    for (const Schema& one : schema.alternatives) text += (text.empty() ? "" : " or ") + value(one);
    return text;
  }

  // The rows below that of an entry.
  void inside(const Schema& schema, const std::string& path, const std::string& when) {
    if (by_parameter(schema)) {
      const SchemaEntry& sample = schema.entries[schema.entries.size() > 5 ? 5 : 0];
      const bool before = std::exchange(in_parameter_, true);
      SchemaEntry any = sample;
      any.schema.text = "one parameter, by name or symbol";
      one(any, path + ".NAME", when);
      in_parameter_ = before;
    } else if (schema.kind == ValueKind::mapping) {
      entries(schema, path + ".", when);
    } else if (schema.kind == ValueKind::named) {
      inside(schema.items.front(), path + ".NAME", when);
    } else if (schema.kind == ValueKind::list) {
      inside(schema.items.front(), path + "[]", when);
    } else if (schema.kind == ValueKind::any_of) {
      for (const Schema& one : schema.alternatives) inside(one, path, when);
    } else if (schema.kind == ValueKind::variant) {
      for (std::size_t i = 0; i < schema.words.size(); ++i)
        variant(schema, schema.alternatives[i], path, schema.words[i]);
    }
  }

  // The rows of one of several mappings; the entry that selects it has one row for all of them.
  void variant(const Schema& all, const Schema& mapping, const std::string& path,
               const std::string& word) {
    for (const SchemaEntry& entry : mapping.entries) {
      if (entry.name != all.selector) one(entry, path + "." + entry.name, word);
    }
  }

  std::string text_;
  bool in_parameter_{false};
};

}  // namespace

std::string markdown_table(const Schema& mapping) {
  TableWriter writer;
  writer.entries(mapping, "", "");
  return "| entry | value | default | text |\n| --- | --- | --- | --- |\n" + writer.take();
}

}  // namespace twum::inline v0_1::io
