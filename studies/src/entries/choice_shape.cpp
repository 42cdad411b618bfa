// SPDX-License-Identifier: Apache-2.0
#include "entries/choice_shape.hpp"

#include <variant>

namespace twum::studies::shapes {
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
  const auto sets = list("files; each design uses one of them", set_of_file());
  Shape<std::vector<DesignChoice>> shape;
  shape.schema.kind = ValueKind::named;
  shape.schema.text = "parameter sets; each design uses one of them; every combination is solved";
  shape.schema.example = "lining: [peek.yaml, ptfe-peek.yaml]";
  shape.schema.sample = shape.schema.example;
  shape.schema.items.push_back(sets.schema);
  shape.read = [schema = kept(shape.schema), sets](std::vector<DesignChoice>& into,
                                                   const YamlNode& node, const Spot& spot,
                                                   Diagnostics& diagnostics) {
    into.clear();
    if (node.kind != YamlNode::Kind::mapping || node.entries.empty()) {
      say_wrong_kind(node, *schema, spot, diagnostics);
      return false;
    }
    bool good = true;
    for (const YamlEntry& entry : node.entries) {
      DesignChoice choice{entry.key, {}};
      good =
          sets.read(choice.sets, entry.value, spot.entry(entry.key, entry.key_mark), diagnostics) &&
          good;
      into.push_back(std::move(choice));
    }
    return good;
  };
  shape.write = [sets](const std::vector<DesignChoice>& choices) {
    YamlNode node;
    node.kind = YamlNode::Kind::mapping;
    for (const DesignChoice& choice : choices)
      node.entries.push_back({choice.name, {}, sets.write(choice.sets)});
    return node;
  };
  return shape;
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

}  // namespace twum::studies::shapes
