// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/schema/publish.hpp>
#include <twum/studies/study/study_file.hpp>

namespace twum::studies {
namespace {

SchemaEntry entry(const char* name, const char* text, const char* example) {
  SchemaEntry result;
  result.name = name;
  result.required = true;
  result.schema.text = text;
  result.schema.example = example;
  return result;
}

}  // namespace

std::string study_template(StudyKind kind) {
  Schema file;
  file.kind = ValueKind::mapping;
  file.entries.push_back(entry("twum", "version of the file format", "1"));
  file.entries.push_back(
      entry("motor", "a motor file, from the folder of this one, or its entries", "ring-60.yaml"));
  file.entries.push_back(entry("set", "overrides of the motor (optional)", "{preload: 140 N}"));
  file.entries.back().shown = false;
  file.entries.push_back(entry("study", "", ""));
  file.entries.back().schema = study_schema(kind);
  return yaml_template(file,
                       "# A study for twum: " + file.entries.back().schema.text + ".\n" +
                           "# Check it with 'twum check FILE', run it with 'twum run FILE'.\n");
}

}  // namespace twum::studies
