// SPDX-License-Identifier: Apache-2.0
#include "results/motion_notes.hpp"

#include <algorithm>

namespace twum::inline v0_1::studies {

std::vector<MotionNote> motion_notes(const motion::Motion& motion) {
  using motion::MotionEventKind;
  const auto happens = [&](MotionEventKind kind) {
    return std::ranges::count(motion.events, kind, &motion::MotionEvent::kind) > 0;
  };
  std::vector<MotionNote> notes;
  if (happens(MotionEventKind::too_fast))
    notes.push_back(
        {"motion-too-fast",
         "The wave and the rotor change within fewer than about five turns of the wave, which is "
         "too fast for the averaged engine. Use 'engine: oscillating'."});
  if (happens(MotionEventKind::squeals))
    notes.push_back(
        {"squeals-while-moving",
         "A backward wave grows, which this motion leaves out. The motor squeals and is slower "
         "than computed at these speeds. 'engine: oscillating' includes the backward wave."});
  if (happens(MotionEventKind::bounces))
    notes.push_back({"bounces",
                     "The rotor begins to hop against its preload, which this motion leaves out. "
                     "'axial: dynamic' includes it."});
  return notes;
}

}  // namespace twum::inline v0_1::studies
