// SPDX-License-Identifier: Apache-2.0
// Lives of motors whose track wears.
#include "entries/entry_shapes.hpp"

#include <twum/io/words.hpp>

namespace twum::studies {

using namespace shapes;

namespace {

bool check_life(LifeStudy& study, const Given& given, Diagnostics& diagnostics) {
  const YamlNode* speed = given.right("speed");
  if (study.torque && speed != nullptr && !(*study.speed > 0))
    diagnostics.add(speed->mark, given.path("speed"), "a torque that is held at rest",
                    "expected a speed of more than 0 rpm; at rest friction holds without a wave");
  return true;
}

}  // namespace

Shape<LifeStudy> LifeStudy::shape() {
  using L = LifeStudy;
  return mapping<L>(
      "how long the motor lives until its track has worn too far, and what changes on the way; of "
      "one motor or of a family over one parameter",
      {kind_field<L>(),
       optional<L>("family", shapes::family("preload: [120 N, 160 N, 200 N]"), &L::family,
                   "the motor alone"),
       optional<L>("torque", io::quantity("load torque", "N.m", "0.5 N.m"), &L::torque,
                   "none; with a speed that of the drive"),
       optional<L>("speed",
                   io::quantity("speed; with a torque the drive holds it", "rad/s", "60 rpm"),
                   &L::speed, "that under the torque"),
       standard<L>("points", count("depths between new and worn", "51", 2, 1e4), &L::points)},
      check_life);
}

}  // namespace twum::studies
