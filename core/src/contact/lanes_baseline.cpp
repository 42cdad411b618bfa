// SPDX-License-Identifier: Apache-2.0
#include "contact/lane_runner.hpp"

namespace twum::contact {

// All that it calls is compiled into it: no other function of this source is left for programs on other processors to take.
[[gnu::flatten]] void run_lanes_baseline(const LayerMotion<double>& layer, LaneBatch& batch) {
  LaneRunner<LaneWidth::baseline>(layer, batch).run();
}

}  // namespace twum::contact
