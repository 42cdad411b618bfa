// SPDX-License-Identifier: Apache-2.0
#include "entries/choice_shape.hpp"

#include "entries/named_shape.hpp"

#include <utility>
#include <variant>

namespace twum::inline v0_1::studies::shapes {
namespace {

// A path, or a path with a name for results.
Shape<ParameterSet> set_of_file() {
  const Shape<std::string> file = path(
      "a file with parameters that belong together, in the blocks of a motor file", "peek.yaml");
  const Shape<ParameterSet> plain = shape_as<ParameterSet, std::string>(
      file,
      [](std::string text) {
        return ParameterSet{text, text, {}};
      },
      [](const ParameterSet& set) { return set.file; });
  const Shape<ParameterSet> with_name = mapping<ParameterSet>(
      "a file and its name",
      {required<ParameterSet>("file", file, &ParameterSet::file),
       required<ParameterSet>("name", path("name in results", "PEEK"), &ParameterSet::name)});
  return one_of<ParameterSet>("the file of a set", {plain, with_name}, [](const ParameterSet& set) {
    return set.name == set.file ? std::size_t{0} : 1;
  });
}

}  // namespace

Shape<std::vector<DesignChoice>> choices() {
  using Sets = std::vector<ParameterSet>;
  const Shape<DesignChoice> choice = shape_as<DesignChoice, Sets>(
      list("files; each design uses one of them", set_of_file()),
      [](Sets sets) {
        return DesignChoice{{}, std::move(sets)};
      },
      [](const DesignChoice& one) { return one.sets; });
  Schema schema;
  schema.text = "parameter sets; each design uses one of them; every combination is solved";
  schema.example = "lining: [peek.yaml, ptfe-peek.yaml]";
  schema.sample = schema.example;
  return named_items(std::move(schema), choice, &DesignChoice::name);
}

std::vector<SetFile> set_files(YamlNode& study) {
  std::vector<SetFile> files;
  for (YamlEntry& choose : study.entries) {
    if (choose.key != "choose") continue;
    for (std::size_t i = 0; i < choose.value.entries.size(); ++i) {
      YamlEntry& choice = choose.value.entries[i];
      for (std::size_t s = 0; s < choice.value.items.size(); ++s) {
        YamlNode& item = choice.value.items[s];
        YamlNode* path = &item;
        for (YamlEntry& entry : item.entries)
          if (entry.key == "file") path = &entry.value;
        if (path->kind != YamlNode::Kind::scalar || path->scalar.empty()) continue;
        files.push_back(
            {i, s, "choose." + choice.key + "[" + std::to_string(s) + "]", &item, path});
      }
    }
  }
  return files;
}

}  // namespace twum::inline v0_1::studies::shapes
