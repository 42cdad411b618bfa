// SPDX-License-Identifier: Apache-2.0
// Laps with derivatives.
#include "contact/lap_runner.hpp"

namespace twum::contact {

#define TWUM_INSTANTIATE(S)                                                                    \
  template Lap<S> run_lap(const ContactNumbers<S>&, const LayerMotion<S>&, const LapEntry<S>&, \
                          const ZoneSequence*, std::vector<ZoneTrace>*, Means);
TWUM_FOR_EACH_CONTACT_DUAL(TWUM_INSTANTIATE)
TWUM_FOR_EACH_WITH_STATE(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

#define TWUM_INSTANTIATE(S)                                                              \
  template LapPlace<S> place_after(int, const ContactNumbers<S>&, const LayerMotion<S>&, \
                                   const LapEntry<S>&);
TWUM_FOR_EACH_MARGIN_DUAL(TWUM_INSTANTIATE)
#undef TWUM_INSTANTIATE

}  // namespace twum::contact
