// SPDX-License-Identifier: Apache-2.0
#include "contact/lap.hpp"

#include "contact/lap_runner.hpp"

namespace twum::inline v0_1::contact {

template <>
Lap<double> run_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                    const LapEntry<double>& entry, const ZoneSequence* sequence,
                    core::Vector<ZoneTrace>* trace, Means means) {
  Lap<double> lap;
  LapRunner<double>(numbers, layer, sequence, trace, means, lap).run(entry);
  return lap;
}

template <>
LapPlace<double> place_after(int zones, const ContactNumbers<double>& numbers,
                             const LayerMotion<double>& layer, const LapEntry<double>& entry) {
  Lap<double> lap;
  LapRunner<double> runner(numbers, layer, nullptr, nullptr, Means::of_wave, lap);
  runner.run(entry, zones);
  return runner.here();
}

LayerState<StateDual> next_entry(const ContactNumbers<StateDual>& numbers,
                                 const LayerMotion<StateDual>& layer,
                                 const LapEntry<StateDual>& entry, const ZoneSequence* sequence) {
  Lap<StateDual> lap;
  LapRunner<StateDual, Ends::searched, false>(numbers, layer, sequence, nullptr, Means::of_wave,
                                              lap)
      .run(entry);
  return lap.next.layer;
}

Lap<double> prove_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                      const LapEntry<double>& entry, const ZoneSequence& near) {
  Lap<double> lap;
  if (near.count > 0 && near.complete()) {
    LapRunner<double, Ends::confirmed>(numbers, layer, &near, nullptr, Means::all, lap).run(entry);
  } else {
    LapRunner<double>(numbers, layer, nullptr, nullptr, Means::all, lap).run(entry);
  }
  return lap;
}

Lap<double> search_states(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                          const LapEntry<double>& entry) {
  Lap<double> lap;
  LapRunner<double, Ends::searched, false>(numbers, layer, nullptr, nullptr, Means::of_wave, lap)
      .run(entry);
  return lap;
}

template <bool kHasMeans>
static Lap<double> followed(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                            const LapEntry<double>& entry, const ZoneSequence& near) {
  Lap<double> lap;
  if (near.complete()) {
    LapRunner<double, Ends::trusted, kHasMeans>(numbers, layer, &near, nullptr, Means::of_wave, lap)
        .run(entry);
  }
  if (lap.sequence.count != near.count) lap.status = LapStatus::unresolved;
  return lap;
}

Lap<double> follow_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                       const LapEntry<double>& entry, const ZoneSequence& near) {
  return followed<true>(numbers, layer, entry, near);
}

Lap<double> follow_states(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                          const LapEntry<double>& entry, const ZoneSequence& near) {
  return followed<false>(numbers, layer, entry, near);
}

}  // namespace twum::inline v0_1::contact
