// SPDX-License-Identifier: Apache-2.0
// Lives of motors whose track wears.
#include "entries/entry_shapes.hpp"

#include <utility>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

bool check_life(LifeStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_held(given, study.torque, study.speed, diagnostics);
  return true;
}

}  // namespace

Shape<LifeStudy> LifeStudy::shape() {
  using L = LifeStudy;
  Fields<L> fields{kind_field<L>(),
                   optional<L>("family", shapes::family("preload: [120 N, 160 N, 200 N]"),
                               &L::family, "the motor alone")};
  fields.push_back(load_fields<L>());
  fields.push_back(standard<L>(
      "points", count("number of wear depths between new and worn", "51", 2, 1e4), &L::points));
  return mapping<L>(
      "the life of the motor until its contact track is worn too far, and how the motor changes "
      "until then; for one motor or a family over one parameter",
      std::move(fields), check_life);
}

}  // namespace twum::inline v0_1::studies
