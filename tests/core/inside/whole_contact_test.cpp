// SPDX-License-Identifier: Apache-2.0
#include "contact/lap.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <array>
#include <cmath>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// Which zone a lap of full contact begins in, by Coulomb's law where it begins, theta = -pi: there cos theta = -1,
// sin theta = 0 and p = w_L - 2.
struct Seam {
  const ContactNumbers<double>& n;
  LayerState<double> state;

  double pressure() const { return n.peak - 2; }
  // e' of a layer that moves with the stator (E1.3).
  double following() const { return n.stick_rate * (-1 - n.speed_ratio); }
  // (E2.3)
  double sticking_traction() const { return state.e + n.damping * following(); }

  // v_rel s / V0 of a layer that slips with v_rel of sign sigma: with inertia e' is that of the state, without
  // it C e' + e = -sigma mu p, and of an elastic layer e' = -sigma mu p' = 0.
  double slip(double sigma) const {
    const double rate = n.inertia > 0   ? state.rate
                        : n.damping > 0 ? (-sigma * n.kinetic * pressure() - state.e) / n.damping
                                        : 0;
    return rate - following();
  }

  static ZoneState slipping(double v_rel) {
    return v_rel > 0 ? ZoneState::slip_minus : ZoneState::slip_plus;
  }

  // A layer without relative velocity sticks if it can, and otherwise slips against the traction it would need.
  ZoneState from_rest() const {
    if (std::fabs(sticking_traction()) <= n.threshold * pressure()) return ZoneState::stick;
    return slipping(-sticking_traction());
  }

  ZoneState after(ZoneState carried) const {
    if (carried == ZoneState::stick) return from_rest();
    const double sigma = carried == ZoneState::slip_minus ? 1 : -1;
    if (sigma * slip(sigma) > 0) return carried;
    return anew();
  }

  ZoneState anew() const { return n.inertia > 0 ? slipping(slip(0)) : from_rest(); }
};

}  // namespace

TEST_CASE(
    "in full contact the zone goes on over the seam as long as Coulomb's law allows (E1.3, E2.3)",
    "[core][contact][identity]") {
  Dice dice(61);
  std::array<int, 3> on{}, other{}, between{};
  for (int i = 0; i < 4000; ++i) {
    ContactNumbers<double> n = random_contact(dice, i, true);
    set_full_contact(n, dice.log_uniform(1.02, 6));
    n.threshold = n.kinetic * dice.uniform(1, 2);
    if (n.inertia == 0 && n.damping > 0) n.damping = dice.log_uniform(0.1, 10);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const double threshold = n.threshold * (n.peak - 2);
    Seam seam{n, {0, 0}};
    // Tractions of a layer that sticks up to three times the threshold; an elastic layer holds no more than it.
    const bool elastic = layer.kind() == LayerKind::elastic;
    seam.state.e =
        threshold * dice.uniform(-1, 1) * (elastic ? 1 : 3) - n.damping * seam.following();
    seam.state.rate = seam.following();
    const double push = dice.uniform(-1, 1);
    const auto carried = static_cast<ZoneState>(i / 5 % 3 - 1);
    if (carried != ZoneState::stick) seam.state.rate += push;

    const LapEntry<double> entry{seam.state, true, carried};
    const Lap<double> lap = run_lap(n, layer, entry);
    REQUIRE(lap.status == LapStatus::ok);
    CAPTURE(i, n.inertia, n.damping, n.threshold / n.kinetic, static_cast<int>(carried));
    CHECK(lap.first == seam.after(carried));
    // What begins in the right zone stays there for a while.
    CHECK(lap.shortest > 1e-9);
    const std::size_t kind = layer.has_inertia() ? 2 : elastic ? 0 : 1;
    ++(lap.first == carried ? on : other)[kind];
    const double traction = std::fabs(seam.sticking_traction());
    between[kind] += traction > n.kinetic * (n.peak - 2) && traction <= threshold;

    const Lap<double> anew = run_lap<double>(n, layer, {seam.state, false, carried});
    if (carried != ZoneState::stick) CHECK(anew.first == seam.anew());
  }
  for (const std::size_t kind : {0u, 1u, 2u}) {
    CAPTURE(kind);
    CHECK(on[kind] > 100);
    CHECK(other[kind] > 100);
    CHECK(between[kind] > 50);
  }
}
