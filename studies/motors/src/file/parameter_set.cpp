// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/parameter_set.hpp>

#include <twum/io/yaml_loader.hpp>

#include <algorithm>

namespace twum::inline v0_1::motors {
namespace {

// Adds a helpful error for a motor or study file given instead of a set, in place of a list of unknown entries.
bool refuse_other_file(const YamlNode& root, Diagnostics& diagnostics) {
  struct Other {
    const char* entry;
    const char* found;
    const char* expected;
  };
  static constexpr Other kOthers[] = {
      {"motor", "found a motor file",
       "expected entries of a motor at the left margin, such as 'contact_layer:', without 'motor:' "
       "around them"},
      {"study", "found a study file", "expected entries of a motor, such as 'contact_layer:'"},
      {"twum_material", "found a file of the catalogue of materials",
       "expected entries of a motor; copy its values below 'contact_layer:' and 'friction:'"}};
  for (const Other& other : kOthers) {
    for (const YamlEntry& entry : root.entries) {
      if (entry.key != other.entry) continue;
      diagnostics.add(entry.key_mark, other.entry, other.found, other.expected);
      return true;
    }
  }
  return false;
}

}  // namespace

bool ParameterSet::gives(Parameter parameter) const {
  return std::any_of(values.begin(), values.end(), [=](const ParameterValue& value) {
    return value.first == parameter || info(value.first).alternative == parameter;
  });
}

std::vector<ParameterValue> read_parameter_set(const Source& source) {
  Diagnostics diagnostics(source);
  const YamlNode root = load_yaml(diagnostics);
  std::vector<ParameterValue> values;
  if (!refuse_other_file(root, diagnostics))
    parameter_set_shape().read(values, root, {{}, {1, 1}}, diagnostics);
  diagnostics.throw_if_any();
  return values;
}

}  // namespace twum::inline v0_1::motors
