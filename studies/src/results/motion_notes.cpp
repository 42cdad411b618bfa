// SPDX-License-Identifier: Apache-2.0
#include "results/motion_notes.hpp"

#include <algorithm>

namespace twum::studies {

std::vector<MotionNote> motion_notes(const motion::Motion& motion) {
  using motion::MotionEventKind;
  const auto happens = [&](MotionEventKind kind) {
    return std::ranges::count(motion.events, kind, &motion::MotionEvent::kind) > 0;
  };
  std::vector<MotionNote> notes;
  if (happens(MotionEventKind::too_fast))
    notes.push_back({"motion-too-fast",
                     "Wave and rotor change within less than thirty turns of the wave, for which "
                     "the averaged engine is not made; "
                     "'engine: oscillating' is."});
  if (happens(MotionEventKind::squeals))
    notes.push_back({"squeals-while-moving",
                     "A backward wave has grown, which this motion leaves out: the motor squeals, "
                     "and is slower than computed until "
                     "it has passed these speeds; 'engine: oscillating' includes it."});
  if (happens(MotionEventKind::bounces))
    notes.push_back({"bounces",
                     "The rotor begins to hop on its preload, which this motion leaves out; "
                     "'axial: dynamic' includes it."});
  return notes;
}

}  // namespace twum::studies
