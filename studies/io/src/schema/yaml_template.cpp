// SPDX-License-Identifier: Apache-2.0
#include <twum/io/publish.hpp>

#include <algorithm>
#include <sstream>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

constexpr std::size_t kCommentColumn = 36;

// True for an entry whose alternative stands before it.
bool is_second(const Schema& schema, const SchemaEntry& entry) {
  if (entry.required || entry.alternative_entry.empty()) return false;
  const auto alternative =
      std::find_if(schema.entries.begin(), schema.entries.end(),
                   [&](const SchemaEntry& other) { return other.name == entry.alternative_entry; });
  return alternative != schema.entries.end() && (alternative->required || &*alternative < &entry);
}

class TemplateWriter {
 public:
  std::string take() { return std::move(text_); }

  void mapping(const Schema& schema, std::size_t depth, bool inside_hidden = false) {
    for (const SchemaEntry& entry : schema.entries) {
      const bool nested = entry.schema.kind == ValueKind::mapping && entry.schema.sample.empty();
      const bool hidden = inside_hidden || !entry.shown || is_second(schema, entry);
      if (nested) {
        line(depth, hidden, entry.name + ":", entry.schema.text);
        mapping(entry.schema, depth + 1, hidden);
      } else {
        value(entry, depth, hidden);
      }
    }
  }

 private:
  // An entry with its example behind it, or its sample below it.
  void value(const SchemaEntry& entry, std::size_t depth, bool hidden) {
    std::string comment = entry.schema.text;
    if (!entry.fallback.empty()) comment += " (optional; default: " + entry.fallback + ")";
    if (!entry.alternative_entry.empty() && !entry.required)
      comment += " (instead of " + entry.alternative_entry + ")";
    if (entry.schema.sample.empty()) {
      line(depth, hidden, entry.name + ": " + entry.schema.example, comment);
      return;
    }
    line(depth, hidden, entry.name + ":", comment);
    std::istringstream sample(entry.schema.sample);
    for (std::string one; std::getline(sample, one);) line(depth + 1, hidden, one, "");
  }

  void line(std::size_t depth, bool commented_out, const std::string& content,
            const std::string& comment) {
    std::string out(2 * depth, ' ');
    if (commented_out) out += "# ";
    out += content;
    if (!comment.empty()) {
      out += std::string(out.size() < kCommentColumn ? kCommentColumn - out.size() : 1, ' ') +
             "# " + comment;
    }
    text_ += out + "\n";
  }

  std::string text_;
};

}  // namespace

std::string yaml_template(const Schema& schema, std::string_view heading) {
  TemplateWriter writer;
  writer.mapping(schema, 0);
  return std::string(heading) + writer.take();
}

}  // namespace twum::inline v0_1::io
