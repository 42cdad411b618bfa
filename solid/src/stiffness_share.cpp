// SPDX-License-Identifier: Apache-2.0
#include <twum/solid/stiffness_share.hpp>

#include <twum/base/error.hpp>
#include <twum/base/scalar_search.hpp>
#include <twum/stator/stator_model.hpp>

namespace twum::inline v0_1::solid {

FittedShare fit_stiffness_share(const stator::StatorGeometry& geometry, int wavelengths,
                                double contact_radius, double frequency) {
  if (!geometry.teeth) throw InputError("a stiffness_share needs teeth, but there are none");
  const auto plate_frequency = [&](double share) {
    stator::StatorGeometry tried = geometry;
    tried.teeth->stiffness_share = share;
    return stator::SolvedStator(tried, wavelengths, contact_radius)
        .wave(stator::Derivatives::none)
        .frequency.v;
  };
  const auto excess = [&](double share) { return plate_frequency(share) - frequency; };
  FittedShare fitted{{}, plate_frequency(0), plate_frequency(1)};
  if (frequency < fitted.lowest || frequency > fitted.highest) return fitted;
  const Bracket ends{0, 1, fitted.lowest - frequency, fitted.highest - frequency};
  // 30 bits: 1e-9 of the share, far below what the solid's mesh leaves open.
  fitted.share = closed_in("stiffness_share", excess, ends, 30).nearest();
  return fitted;
}

}  // namespace twum::inline v0_1::solid
