// SPDX-License-Identifier: Apache-2.0
// Temperatures under a load and over an operation.
#include "entries/entry_shapes.hpp"

#include <twum/io/words.hpp>

namespace twum::studies {

using namespace shapes;

namespace {

bool check_heat(HeatStudy& study, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* speed = given.right("speed");
  if (study.torque && speed != nullptr && !(*study.speed > 0))
    diagnostics.add(speed->mark, given.path("speed"), "a torque that is held at rest",
                    "expected a speed of more than 0 rpm; at rest friction holds without a wave");
  const YamlNode* time = given.right("time");
  if (time != nullptr && !(*study.time > 0))
    diagnostics.add(time->mark, given.path("time"), quoted(time->scalar),
                    "expected the time of the warm-up, more than 0 s");
  return true;
}

}  // namespace

Shape<HeatStudy> HeatStudy::shape() {
  using H = HeatStudy;
  return mapping<H>(
      "how warm the motor gets under a load, how fast, and over a cycle of its operation; of one "
      "motor or of a family over one parameter",
      {kind_field<H>(),
       optional<H>("family", shapes::family("preload: [120 N, 160 N, 200 N]"), &H::family,
                   "the motor alone"),
       optional<H>("torque", io::quantity("load torque", "N.m", "0.5 N.m"), &H::torque,
                   "none; with a speed that of the drive"),
       optional<H>("speed",
                   io::quantity("speed; with a torque the drive holds it", "rad/s", "60 rpm"),
                   &H::speed, "that under the torque"),
       optional<H>("time", io::quantity("how long the warm-up is followed", "s", "1 h"), &H::time,
                   "five times the slowest time constant"),
       standard<H>(
           "points",
           count("times of the warm-up, or of a cycle where there is no load", "101", 2, 1e5),
           &H::points)},
      check_heat);
}

}  // namespace twum::studies
