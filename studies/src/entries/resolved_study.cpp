// SPDX-License-Identifier: Apache-2.0
#include "entries/resolved_study.hpp"

#include "entries/choice_shape.hpp"
#include "entries/study_kinds.hpp"
#include "store/written_content.hpp"
#include "text/checksum.hpp"
#include "text/file_content.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/base/error.hpp>
#include <twum/io/words.hpp>
#include <twum/io/yaml_loader.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>
#include <map>
#include <optional>

namespace twum::inline v0_1::studies {
namespace {

namespace fs = std::filesystem;

bool gives(const YamlNode& mapping, const SchemaEntry& entry) {
  return mapping.find(entry.name) != nullptr ||
         (entry.alias_counts && !entry.alias.empty() && mapping.find(entry.alias) != nullptr);
}

// The enclosing mappings, outermost first; their entries decide which defaults apply.
using Around = std::vector<const YamlNode*>;

const YamlNode* standard_of(const SchemaEntry& entry, const Around& around) {
  const auto holds = [&](const StandardValue& one) {
    if (one.selector.empty()) return true;
    for (const YamlNode* mapping : around) {
      const YamlNode* word = mapping->find(one.selector);
      if (word != nullptr)
        return std::find(one.words.begin(), one.words.end(), word->scalar) != one.words.end();
    }
    return false;
  };
  const auto found = std::find_if(entry.standards.begin(), entry.standards.end(), holds);
  return found == entry.standards.end() ? nullptr : &found->value;
}

YamlNode complete(const YamlNode& node, const Schema& schema, const Around& around);

YamlNode complete_mapping(YamlNode node, const Schema& schema, Around around) {
  const YamlNode typed = node;
  around.push_back(&typed);
  for (YamlEntry& given : node.entries) {
    for (const SchemaEntry& entry : schema.entries) {
      const bool by_alias = entry.alias_counts && entry.alias == given.key;
      if (entry.name != given.key && !by_alias) continue;
      given.key = entry.name;
      given.value = complete(given.value, entry.schema, around);
      break;
    }
  }
  for (const SchemaEntry& entry : schema.entries) {
    if (entry.required || gives(node, entry)) continue;
    if (const YamlNode* value = standard_of(entry, around))
      node.entries.push_back({entry.name, {}, complete(*value, entry.schema, around)});
  }
  return node;
}

// A name in place of a mapping of options becomes a mapping with that name.
YamlNode complete_any(const YamlNode& node, const Schema& schema, const Around& around) {
  for (const Schema& one : schema.alternatives) {
    const bool named = one.kind == ValueKind::mapping && node.kind == YamlNode::Kind::scalar &&
                       !one.entries.empty() && one.entries.front().name == "name";
    if (named) {
      YamlNode options;
      options.kind = YamlNode::Kind::mapping;
      options.entries.push_back({"name", {}, node});
      return complete_mapping(options, one, around);
    }
    if (one.kind == ValueKind::mapping && node.kind == YamlNode::Kind::mapping)
      return complete_mapping(node, one, around);
  }
  return node;
}

YamlNode complete(const YamlNode& node, const Schema& schema, const Around& around) {
  switch (schema.kind) {
    case ValueKind::mapping: return complete_mapping(node, schema, around);
    case ValueKind::any_of: return complete_any(node, schema, around);
    case ValueKind::variant: {
      const YamlNode* word = node.find(schema.selector);
      for (std::size_t i = 0; word != nullptr && i < schema.words.size(); ++i) {
        if (word->scalar == schema.words[i])
          return complete_mapping(node, schema.alternatives[i], around);
      }
      return node;
    }
    case ValueKind::list: {
      YamlNode list = node;
      for (YamlNode& item : list.items) item = complete(item, schema.items.front(), around);
      return list;
    }
    default: return node;
  }
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

// A path that an entry names, and by what it is known: "data", and of a list "data", "data[1]", ...
struct PathEntry {
  std::string name;
  YamlNode* node;
};

std::vector<PathEntry> path_entries(YamlNode& study) {
  std::vector<PathEntry> list;
  for (YamlEntry& entry : study.entries) {
    if (entry.key != "data" && entry.key != "start" && entry.key != "parts") continue;
    if (entry.value.kind != YamlNode::Kind::list) list.push_back({entry.key, &entry.value});
    for (std::size_t k = 0; k < entry.value.items.size(); ++k)
      list.push_back(
          {entry.key + (k == 0 ? "" : "[" + std::to_string(k) + "]"), &entry.value.items[k]});
  }
  return list;
}

// Puts another path for a file that the study names. A set keeps the name that results know it by.
void set_path(YamlNode& study, const std::string& entry, const std::string& path) {
  for (const PathEntry& one : path_entries(study))
    if (one.name == entry) one.node->scalar = path;
  for (const shapes::SetFile& file : shapes::set_files(study)) {
    if (file.entry != entry) continue;
    if (file.item != file.path) {
      file.path->scalar = path;
      continue;
    }
    const YamlNode name = *file.item;
    *file.item = YamlNode{};
    file.item->kind = YamlNode::Kind::mapping;
    file.item->entries = {{"file", {}, scalar_node(path)}, {"name", {}, name}};
  }
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

constexpr std::size_t kLargestCopy = 10'000'000;  // bytes

std::string hash_of(const ResolvedStudy::NamedFile& file, const std::string& content) {
  return hex(checksum(file.entry == "start" ? without_times(content) : content));
}

// Adds a file with its hash and the place of its copy, which keeps its name: answers name tables and sets by it.
void add_file(std::vector<ResolvedStudy::NamedFile>& files, const std::string& entry,
              const fs::path& path) {
  ResolvedStudy::NamedFile file{entry, path.string(), {}, {}};
  const std::string content = file_content(file.source(), kLargestResult);
  file.hash = hash_of(file, content);
  const std::string name = (path.has_filename() ? path : path.parent_path()).filename().string();
  std::string copy = "inputs/" + name;
  const auto taken = [&](const ResolvedStudy::NamedFile& other) { return other.copy == copy; };
  for (int k = 2; std::ranges::any_of(files, taken); ++k)
    copy = "inputs/" + std::to_string(k) + "/" + name;
  if (content.size() <= kLargestCopy) file.copy = copy;
  files.push_back(std::move(file));
}

}  // namespace

std::string content_of(const ResolvedStudy::NamedFile& file) {
  std::string content = file_content(file.source(), kLargestResult);
  if (hash_of(file, content) != file.hash)
    throw InputError(file.source() + ": has changed while the study was being read; run it again");
  return content;
}

ResolvedStudy resolve(const StudyFile& file) {
  const Shape<Study>& shape = study_shape(file.kind());
  ResolvedStudy result{file.motor, {}, shape.write(file.asked), {}};
  const bool typed = file.study.kind == YamlNode::Kind::mapping;
  result.study = complete(typed ? file.study : result.meaning, shape.schema, {});
  const fs::path folder(file.folder);
  for (const shapes::SetFile& set : shapes::set_files(result.study))
    add_file(result.files, set.entry, folder / set.path->scalar);
  for (const PathEntry& entry : path_entries(result.study))
    add_file(result.files, entry.name, folder / entry.node->scalar);
  return result;
}

std::string ResolvedStudy::text(const std::string& folder) const {
  YamlNode shown = study;
  for (const NamedFile& file : files) {
    if (folder.empty()) continue;
    const fs::path from_there = fs::absolute(file.path).lexically_normal().lexically_relative(
        fs::absolute(folder).lexically_normal());
    set_path(shown, file.entry, file.copy.empty() ? from_there.string() : file.copy);
  }
  return motor_text(motor) + "study:\n" + yaml_text(shown, 1);
}

std::string ResolvedStudy::hash() const {
  // The hash depends on the content of files, not on their paths.
  YamlNode by_content = meaning;
  for (const NamedFile& file : files) set_path(by_content, file.entry, file.hash);
  return hex(checksum(motor_text(motor) + "study:\n" + yaml_text(by_content, 1)));
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

}  // namespace twum::inline v0_1::studies
