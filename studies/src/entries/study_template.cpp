// SPDX-License-Identifier: Apache-2.0
#include <twum/io/publish.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/studies/study_file.hpp>

#include <twum/io/number.hpp>

#include <algorithm>

namespace twum::inline v0_1::studies {
namespace {

SchemaEntry entry(const char* name, const char* text, const std::string& example) {
  SchemaEntry result;
  result.name = name;
  result.required = true;
  result.schema.text = text;
  result.schema.example = example;
  return result;
}

// In quotes if YAML would read the plain path as something else, such as null.
std::string path_text(std::string_view path) {
  const bool plain = path.find_first_not_of(
                         "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_./-") ==
                         std::string_view::npos &&
                     path.find_first_of("./") != std::string_view::npos && path.front() != '-';
  if (plain) return std::string(path);
  std::string text = "'";
  for (const char c : path) text += c == '\'' ? "''" : std::string(1, c);
  return text + "'";
}

// The motor's entries, showing those of a motor under a voltage.
SharedList<SchemaEntry> driven_motor_entries() {
  SharedList<SchemaEntry> all = motor_shape().schema.entries;
  std::vector<SchemaEntry>& entries = all.own();
  const auto stator = std::find_if(entries.begin(), entries.end(),
                                   [](const SchemaEntry& one) { return one.name == "stator"; });
  for (SchemaEntry& one : stator->schema.entries.own()) {
    if (one.name == "amplitude") one.shown = one.required = false;
    if (one.name == "voltage") one.required = true;  // in place of the amplitude
    for (const char* driven : {"voltage", "resonance_frequency", "modal_mass", "force_factor",
                               "blocked_capacitance", "loss_tangent"})
      if (one.name == driven) one.shown = true;
  }
  return all;
}

// Lines of a template that vary the amplitude first, with the voltage in its place.
std::string with_voltage(std::string lines, double voltage) {
  constexpr std::string_view kAmplitude = "amplitude: ";
  if (!lines.starts_with(kAmplitude)) return lines;
  const auto volts = [voltage](double share) { return rounded_text(share * voltage, 3) + " V"; };
  const std::size_t end = std::min(lines.find('\n'), lines.size());
  const std::string line = lines.substr(0, end);
  const std::size_t points = line.find(", points");
  const std::string range = line.find('{') == std::string::npos
                                ? "[" + volts(0.8) + ", " + volts(1) + ", " + volts(1.2) + "]"
                                : "{min: " + volts(0.8) + ", max: " + volts(1.2) +
                                      (points == std::string::npos ? "}" : line.substr(points));
  return "voltage: " + range + lines.substr(end);
}

}  // namespace

std::string study_template(StudyKind kind, std::string_view motor, std::optional<double> voltage) {
  Schema file;
  file.kind = ValueKind::mapping;
  std::vector<SchemaEntry>& entries = file.entries.own();
  entries.push_back(entry("twum", "version of the file format", "1"));
  if (!motor.empty())
    entries.push_back(entry("motor", "path of a motor file, relative to the folder of this file",
                            path_text(motor)));
  entries.push_back(entry("set", "overrides of the motor (optional)", "{preload: 140 N}"));
  entries.back().shown = false;
  entries.push_back(entry("study", "", ""));
  entries.back().schema = study_schema(kind);
  if (voltage)
    for (SchemaEntry& one : entries.back().schema.entries.own())
      one.schema.sample = with_voltage(one.schema.sample, *voltage);
  const std::string heading = "# A study for twum: " + entries.back().schema.text + ".\n" +
                              "# Check it with 'twum check FILE', run it with 'twum run FILE'.\n";
  if (motor.empty()) {  // after the study, which is more important
    entries.push_back(entry(
        "motor", "or the path of a motor file, relative to the folder of this file: 'motor: FILE'",
        ""));
    entries.back().schema.kind = ValueKind::mapping;
    entries.back().schema.entries =
        kind == StudyKind::frequency ? driven_motor_entries() : motor_shape().schema.entries;
  }
  return yaml_template(file, heading);
}

}  // namespace twum::inline v0_1::studies
