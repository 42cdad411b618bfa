// SPDX-License-Identifier: Apache-2.0
// Temperatures under a load and over an operation.
#include "entries/entry_shapes.hpp"

#include <twum/io/words.hpp>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

bool check_heat(HeatStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_held(given, study.torque, study.speed, diagnostics);
  const YamlNode* time = given.right("time");
  if (time != nullptr && !(*study.time > 0))
    diagnostics.add(time->mark, given.path("time"), quoted(time->scalar),
                    "expected the time of the warm-up, more than 0 s");
  return true;
}

}  // namespace

Shape<HeatStudy> HeatStudy::shape() {
  using H = HeatStudy;
  Fields<H> fields{kind_field<H>(),
                   optional<H>("family", shapes::family("preload: [120 N, 160 N, 200 N]"),
                               &H::family, "the motor alone")};
  fields.push_back(load_fields<H>());
  fields.push_back(optional<H>("time", io::quantity("duration of the warm-up", "s", "1 h"),
                               &H::time, "five times the slowest time constant"));
  fields.push_back(standard<H>(
      "points",
      count("number of times in the warm-up, or in a cycle if no load is given", "101", 2, 1e5),
      &H::points));
  return mapping<H>(
      "how warm the motor gets under a load, how fast, and over a cycle of its operation; for one "
      "motor or a family over one parameter",
      std::move(fields), check_heat);
}

}  // namespace twum::inline v0_1::studies
