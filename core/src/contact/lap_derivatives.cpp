// SPDX-License-Identifier: Apache-2.0
// Laps with derivatives.
#include "contact/lap_runner.hpp"

namespace twum::inline v0_1::contact {

template <typename S>
Lap<S> run_lap(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
               const LapEntry<S>& entry, const ZoneSequence* sequence,
               core::Vector<ZoneTrace>* trace, Means means) {
  Lap<S> lap;
  LapRunner<S>(numbers, layer, sequence, trace, means, lap).run(entry);
  return lap;
}

template <typename S>
LapPlace<S> place_after(int zones, const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
                        const LapEntry<S>& entry) {
  Lap<S> lap;
  LapRunner<S> runner(numbers, layer, nullptr, nullptr, Means::of_wave, lap);
  runner.run(entry, zones);
  return runner.here();
}

#define TWUM_INSTANTIATE(S)                                                                    \
  template Lap<S> run_lap(const ContactNumbers<S>&, const LayerMotion<S>&, const LapEntry<S>&, \
                          const ZoneSequence*, core::Vector<ZoneTrace>*, Means);
TWUM_FOR_EACH_CONTACT_DUAL(TWUM_INSTANTIATE)
TWUM_FOR_EACH_WITH_STATE(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

#define TWUM_INSTANTIATE(S)                                                              \
  template LapPlace<S> place_after(int, const ContactNumbers<S>&, const LayerMotion<S>&, \
                                   const LapEntry<S>&);
TWUM_FOR_EACH_MARGIN_DUAL(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::inline v0_1::contact
