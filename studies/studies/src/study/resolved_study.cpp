// SPDX-License-Identifier: Apache-2.0
#include "study/resolved_study.hpp"

#include "schema/scalar_checks.hpp"
#include "study/sweep_checks.hpp"
#include "text/checksum.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>
#include <twum/studies/yaml/loader.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <filesystem>
#include <fstream>
#include <map>
#include <optional>
#include <sstream>

namespace twum::studies {
namespace {

namespace fs = std::filesystem;

YamlNode scalar(std::string_view text) {
  YamlNode node;
  node.kind = YamlNode::Kind::scalar;
  node.scalar = text;
  return node;
}

bool is_value(std::string_view text, const Schema& schema) {
  // Any text will do for a path: a single word is one, "the motor as it is" speaks of the default.
  if (schema.kind == ValueKind::text && schema.check == nullptr)
    return text.find(' ') == std::string_view::npos;
  try {
    check_scalar(text, schema);
    return true;
  } catch (const ValueError&) {
    return false;
  }
}

// The value that a fallback stands for; nothing if it is words.
std::optional<YamlNode> value_of(const std::string& fallback, const Schema& schema) {
  if (fallback.empty()) return {};
  switch (schema.kind) {
    case ValueKind::quantity:
    case ValueKind::count:
    case ValueKind::text:
    case ValueKind::word:
      if (is_value(fallback, schema)) return scalar(fallback);
      return {};
    case ValueKind::any_of: return value_of(fallback, schema.alternatives.front());
    case ValueKind::list: {
      YamlNode list;
      list.kind = YamlNode::Kind::list;
      for (const std::string_view one : split_list(fallback)) {
        if (!is_value(one, schema.items.front())) return {};
        list.items.push_back(scalar(one));
      }
      return list;
    }
    default: return {};
  }
}

bool gives(const YamlNode& mapping, const SchemaEntry& entry) {
  return mapping.find(entry.name) != nullptr ||
         (entry.alias_counts && !entry.alias.empty() && mapping.find(entry.alias) != nullptr);
}

// "1000, for lhs and sobol" is 1000 where another entry is one of these words, and nothing elsewhere.
std::string fallback_in(const YamlNode& mapping, const SchemaEntry& entry) {
  constexpr std::string_view kFor = ", for ";
  const std::size_t at = entry.fallback.find(kFor);
  if (at == std::string::npos) return entry.fallback;
  const std::string words = " " + entry.fallback.substr(at + kFor.size()) + " ";
  const bool holds =
      std::any_of(mapping.entries.begin(), mapping.entries.end(), [&](const YamlEntry& other) {
        return other.value.kind == YamlNode::Kind::scalar &&
               words.find(" " + other.value.scalar + " ") != std::string::npos;
      });
  return holds ? entry.fallback.substr(0, at) : std::string();
}

YamlNode complete(const YamlNode& node, const Schema& schema);

YamlNode complete_mapping(YamlNode node, const Schema& schema) {
  for (YamlEntry& given : node.entries) {
    for (const SchemaEntry& entry : schema.entries) {
      const bool by_alias = entry.alias_counts && entry.alias == given.key;
      if (entry.name != given.key && !by_alias) continue;
      given.key = entry.name;
      given.value = complete(given.value, entry.schema);
      break;
    }
  }
  for (const SchemaEntry& entry : schema.entries) {
    if (entry.required || gives(node, entry)) continue;
    if (const auto value = value_of(fallback_in(node, entry), entry.schema))
      node.entries.push_back({entry.name, {}, complete(*value, entry.schema)});
  }
  return node;
}

// Where a name may stand for a mapping of options, it stands for one with that name.
YamlNode complete_any(const YamlNode& node, const Schema& schema) {
  for (const Schema& one : schema.alternatives) {
    const bool named = one.kind == ValueKind::mapping && node.kind == YamlNode::Kind::scalar &&
                       !one.entries.empty() && one.entries.front().name == "name";
    if (named) {
      YamlNode options;
      options.kind = YamlNode::Kind::mapping;
      options.entries.push_back({"name", {}, node});
      return complete_mapping(options, one);
    }
    if (one.kind == ValueKind::mapping && node.kind == YamlNode::Kind::mapping)
      return complete_mapping(node, one);
  }
  return node;
}

YamlNode complete(const YamlNode& node, const Schema& schema) {
  switch (schema.kind) {
    case ValueKind::mapping: return complete_mapping(node, schema);
    case ValueKind::any_of: return complete_any(node, schema);
    case ValueKind::variant: {
      const YamlNode* word = node.find(schema.selector);
      for (std::size_t i = 0; word != nullptr && i < schema.words.size(); ++i) {
        if (word->scalar == schema.words[i]) return complete_mapping(node, schema.alternatives[i]);
      }
      return node;
    }
    case ValueKind::list: {
      YamlNode list = node;
      for (YamlNode& item : list.items) item = complete(item, schema.items.front());
      return list;
    }
    default: return node;
  }
}

std::string content_of(const std::string& path) {
  std::error_code ignored;
  std::ifstream file(path, std::ios::binary);
  std::ostringstream content;
  if (!file || fs::is_directory(path, ignored) || !(content << file.rdbuf()))
    throw InputError(path + ": cannot be read");
  return content.str();
}

std::string hex(std::uint64_t value) {
  std::string text(16, '0');
  for (std::size_t i = 16; i-- > 0; value >>= 4U) text[i] = "0123456789abcdef"[value & 15U];
  return text;
}

// A summary of another study without what depends on the time of its run.
std::string without_times(const std::string& summary) {
  auto json = nlohmann::ordered_json::parse(summary, nullptr, false);
  if (!json.is_object()) return summary;
  json.erase("seconds");
  json.erase("started");
  return json.dump(-1, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

// "study.variables.preload.min" -> "60 N"
void flatten(const YamlNode& node, const std::string& path,
             std::map<std::string, std::string>& values) {
  if (node.kind == YamlNode::Kind::scalar) values[path] = node.scalar;
  for (const YamlEntry& entry : node.entries)
    flatten(entry.value, path.empty() ? entry.key : path + "." + entry.key, values);
  for (std::size_t i = 0; i < node.items.size(); ++i)
    flatten(node.items[i], path + "[" + std::to_string(i) + "]", values);
}

std::map<std::string, std::string> flat(const std::string& text) {
  const Source source("study", text);
  Diagnostics ignored(source);
  std::map<std::string, std::string> values;
  flatten(load_yaml(ignored), {}, values);
  return values;
}

}  // namespace

ResolvedStudy resolve(const StudyFile& file) {
  ResolvedStudy result{file.motor, complete(file.study, study_schema(file.kind)), {}};
  if (file.kind == StudyKind::sweep) result.study = with_sweep_defaults(std::move(result.study));
  constexpr std::array<std::string_view, 2> kPaths{"data", "start"};
  for (const std::string_view entry : kPaths) {
    const YamlNode* node = result.study.find(entry);
    if (node == nullptr) continue;
    const std::string path = (fs::path(file.folder) / node->scalar).string();
    const std::string content =
        entry == "start" ? without_times(content_of((fs::path(path) / "summary.json").string()))
                         : content_of(path);
    result.files.push_back({std::string(entry), path, hex(checksum(content))});
  }
  return result;
}

std::string ResolvedStudy::text(const std::string& folder) const {
  YamlNode shown = study;
  for (const NamedFile& file : files) {
    for (YamlEntry& entry : shown.entries) {
      if (folder.empty() || entry.key != file.entry) continue;
      entry.value.scalar = fs::absolute(file.path)
                               .lexically_normal()
                               .lexically_relative(fs::absolute(folder).lexically_normal())
                               .string();
    }
  }
  return motor_text(motor) + "study:\n" + yaml_text(shown, 1);
}

std::string ResolvedStudy::hash() const {
  // What a file holds counts, not where it stands.
  ResolvedStudy by_content = *this;
  for (YamlEntry& entry : by_content.study.entries) {
    for (const NamedFile& file : files) {
      if (entry.key == file.entry) entry.value.scalar = file.hash;
    }
  }
  return hex(checksum(by_content.text()));
}

std::vector<std::string> differences(const std::string& stored, const std::string& now) {
  const auto there = flat(stored);
  const auto here = flat(now);
  std::vector<std::string> lines;
  const auto value = [](const std::map<std::string, std::string>& values, const std::string& path) {
    const auto found = values.find(path);
    return found == values.end() ? std::string("nothing") : studies::quoted(found->second);
  };
  auto all = there;
  all.insert(here.begin(), here.end());
  for (const auto& [path, ignored] : all) {
    const std::string a = value(there, path);
    const std::string b = value(here, path);
    if (a != b) lines.push_back(path + ": " + a + " there, " + b + " here");
  }
  return lines;
}

}  // namespace twum::studies
