// SPDX-License-Identifier: Apache-2.0
#include "contact/lane_runner.hpp"

namespace twum::inline v0_1::contact {

// All that it calls is compiled into it: no other function of this source is left for programs on other processors to take.
TWUM_FLATTEN void run_lanes_avx2(const LayerMotion<double>& layer, LaneBatch& batch) {
  constexpr LaneWidth kThis = LaneWidth::avx2;
  for (int lane = 0; lane < kLanes; lane += kWidth<kThis>)
    LaneRunner<kThis>(layer, batch, lane).run();
}

}  // namespace twum::inline v0_1::contact
