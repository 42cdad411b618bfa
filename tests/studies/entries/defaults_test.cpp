// SPDX-License-Identifier: Apache-2.0
// Defaults: what a study leaves out is what it would say.
#include "entries/resolved_study.hpp"
#include "entries_support.hpp"
#include "yaml/yaml_text.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <set>
#include <string>
#include <utility>
#include <vector>

using namespace twum::studies;
using namespace twum::test;

namespace {

// The least that each kind may say; sweeps and sensitivities once for each word that decides defaults.
std::vector<std::string> shortest_studies() {
  const std::string range = "variables: {preload: {min: 100 N, max: 200 N}}";
  const std::string asked = range + ", metrics: [stall_torque]";
  std::vector<std::string> studies{
      "{kind: curve}",
      "{kind: frequency}",
      "{kind: map}",
      "{kind: heat, torque: 0.5 N.m}",
      "{kind: life, torque: 0.5 N.m}",
      "{kind: motion, duration: 10 ms}",
      "{kind: motion, duration: 10 ms, control: {kind: speed, reference: 120 rpm, range: [39.7 "
      "kHz, "
      "44.5 kHz]}}",
      "{kind: motion, duration: 10 ms, control: {kind: position, reference: 0.5 rad, range: [40.2 "
      "kHz, 43.6 kHz]}}",
      "{kind: optimize, maximize: peak_power, " + range + "}",
      "{kind: pareto, objectives: [{maximize: peak_power}, {minimize: preload}], " + range + "}",
      "{kind: size, duty: [{torque: 0.5 N.m, speed: 100 rpm}], " + range + "}",
      "{kind: uncertainty, metrics: [stall_torque], variables: {preload: {distribution: normal, "
      "mean: 160 N, sd: 8 N}}}",
      "{kind: calibrate, data: points.csv, " + range + "}"};
  for (const char* sampling : {"grid", "lhs", "sobol"})
    studies.push_back(std::string("{kind: sweep, sampling: ") + sampling + ", " + asked + "}");
  studies.push_back(
      "{kind: sweep, sampling: list, metrics: [stall_torque], variables: {preload: "
      "[100 N, 200 N]}}");
  for (const char* method : {"local", "morris", "sobol"})
    studies.push_back(std::string("{kind: sensitivity, method: ") + method + ", " + asked + "}");
  return studies;
}

// Every way to write one more of the defaults of `full` into `typed`: behind the others, or in front.
std::vector<YamlNode> with_one_more(const YamlNode& typed, const YamlNode& full,
                                    const std::string& path, std::set<std::string>& written) {
  std::vector<YamlNode> studies;
  for (const YamlEntry& entry : full.entries) {
    const auto given = std::find_if(typed.entries.begin(), typed.entries.end(),
                                    [&](const YamlEntry& one) { return one.key == entry.key; });
    const std::string name = path + "." + entry.key;
    if (given == typed.entries.end()) {
      written.insert(name);
      YamlNode behind = typed;
      behind.entries.push_back(entry);
      YamlNode before = typed;
      before.entries.insert(before.entries.begin(), entry);
      studies.push_back(std::move(behind));
      studies.push_back(std::move(before));
      continue;
    }
    const auto place = static_cast<std::size_t>(given - typed.entries.begin());
    for (YamlNode& inner : with_one_more(given->value, entry.value, name, written)) {
      YamlNode whole = typed;
      whole.entries[place].value = std::move(inner);
      studies.push_back(std::move(whole));
    }
  }
  return studies;
}

// Names of entries that have a value if they are left out, from the field lists.
void with_standards(const Schema& schema, const std::string& path, std::set<std::string>& names) {
  for (const SchemaEntry& entry : schema.entries) {
    const bool any_parameter = entry.alias_counts && entry.name != "preload";
    if (any_parameter) continue;
    if (!entry.standards.empty()) names.insert(path + "." + entry.name);
    with_standards(entry.schema, path + "." + entry.name, names);
  }
  for (const Schema& one : schema.alternatives) with_standards(one, path, names);
}

}  // namespace

TEST_CASE("a default that is written out leaves the study what it is", "[studies][run]") {
  const ScratchFolder folder;
  write(folder.path("points.csv"), "speed [rpm],torque [N.m]\n1,0.8\n2,0.8\n");
  std::set<std::string> written;
  for (const std::string& text : shortest_studies()) {
    CAPTURE(text);
    // A sweep of the frequency needs a voltage, a motion an inertia.
    const bool driven = text.find("kind: frequency") != std::string::npos;
    const bool moving = text.find("kind: motion") != std::string::npos;
    const std::string motor = driven ? "drive-60" : moving ? "moving-60" : "elastic-layer";
    const StudyFile file = study_in(folder, text, motor);
    const ResolvedStudy study = resolve(file);
    const std::string kind(to_string(file.kind()));
    for (const YamlNode& more : with_one_more(file.study, study.study, kind, written)) {
      const std::string longer = "\n" + yaml_text(more, 1);
      CAPTURE(longer);
      CHECK(resolve(study_in(folder, longer, motor)).hash() == study.hash());
    }
  }
  // No default of a field list was left out of this. Those inside `solver:` follow from `auto`.
  std::set<std::string> listed;
  for (std::size_t i = 0; i < study_kinds().size(); ++i)
    with_standards(study_schema(static_cast<StudyKind>(i)), std::string(study_kinds()[i]), listed);
  for (const std::string& name : listed) {
    if (name.find(".solver.") != std::string::npos) continue;
    CAPTURE(name);
    CHECK(written.count(name) == 1);
  }
}

TEST_CASE("defaults of a solver that are written out leave the study what it is",
          "[studies][run]") {
  const ScratchFolder folder;
  for (const std::string kind : {"optimize, maximize: peak_power",
                                 "pareto, objectives: [{maximize: "
                                 "peak_power}, {minimize: preload}]"}) {
    const std::string study =
        "{kind: " + kind + ", variables: {preload: {min: 100 N, max: 200 N}}, solver: ";
    const ResolvedStudy plain = resolve(study_in(folder, study + "auto}"));
    const YamlNode full = *plain.study.find("solver");
    // The sample is one of searches for one design.
    REQUIRE(full.entries.size() == (kind[0] == 'o' ? 6 : 5));
    for (const YamlEntry& entry : full.entries) {
      CAPTURE(entry.key);
      const std::string one = "{" + entry.key + ": " + entry.value.scalar + "}";
      CHECK(resolve(study_in(folder, study + one + "}")).hash() == plain.hash());
    }
  }
}

TEST_CASE("a quantity in another unit is the same study", "[studies][run]") {
  const ScratchFolder folder;
  const auto hash = [&](const char* range) {
    return resolve(study_in(folder, std::string("{kind: optimize, maximize: peak_power, variables: "
                                                "{preload: ") +
                                        range + "}}"))
        .hash();
  };
  CHECK(hash("{min: 100 N, max: 200 N}") == hash("{max: 0.2 kN, min: 0.1 kN}"));
  CHECK(hash("{min: 100 N, max: 200 N}") != hash("{min: 100 N, max: 201 N}"));
}

TEST_CASE("a study that a program asks is the study of the file that says the same",
          "[studies][run]") {
  const ScratchFolder folder;
  const StudyFile file = study_in(
      folder,
      "{kind: size, duty: [{torque: 0.5 N.m, speed: 10 rad/s}], limits: [\"max_pressure <= 10 "
      "MPa\"], variables: {preload: {min: 100 N, max: 200 N}}}");
  SizeStudy asked;
  asked.variables = {{twum::Parameter::preload, 100, 200}};
  asked.duty = {parse_limit("torque_at(10 rad/s) >= 0.5 N.m")};
  asked.limits = {parse_limit("max_pressure <= 10 MPa")};
  const StudyFile own{file.motor, asked};
  CHECK(resolve(own).hash() == resolve(file).hash());
  // Its text is a study file that says so.
  write(folder.path("own.yaml"), "twum: 1\n" + resolve(own).text());
  const std::string text = resolve(own).text();
  CHECK(resolve(read_study(Source("own", text), folder.folder())).hash() == resolve(file).hash());
}
