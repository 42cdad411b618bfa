// SPDX-License-Identifier: Apache-2.0
#include "contact/slip_margin.hpp"
#include "contact/scalars.hpp"
#include "in_scalar.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <vector>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// Layers of every kind, of contacts up to nearly the whole wave and speeds up to the wave's.
ContactNumbers<double> driven_contact(Dice& dice, int index) {
  ContactNumbers<double> n = random_contact(dice, index);
  n.speed_ratio = dice.uniform(0, 1);
  set_half_angle(n, dice.uniform(0.1, 3.1));
  return n;
}

// Layers that still ring at entry from the contact before: slow to decay, and fast against the contact.
ContactNumbers<double> ringing_contact(Dice& dice) {
  ContactNumbers<double> n = random_contact(dice, 2);
  n.inertia = dice.log_uniform(0.003, 0.1);
  n.damping = 2 * dice.log_uniform(0.003, 0.05) * std::sqrt(n.inertia);
  n.speed_ratio = dice.uniform(0, 1);
  set_half_angle(n, dice.uniform(0.5, 3.1));
  return n;
}

// Layers with M > 1: their own resonance lies below the wave's frequency.
ContactNumbers<double> heavy_contact(Dice& dice) {
  ContactNumbers<double> n = random_contact(dice, 2);
  n.inertia = dice.uniform(1.2, 4);
  n.damping = dice.log_uniform(0.01, 2);
  n.speed_ratio = dice.uniform(0, 1);
  set_half_angle(n, dice.uniform(0.1, 3.0));
  return n;
}

// All of these in turn.
ContactNumbers<double> any_contact(Dice& dice, int index) {
  if (index % 4 == 2) return ringing_contact(dice);
  return index % 4 == 3 ? heavy_contact(dice) : driven_contact(dice, index / 2);
}

// The layer that slips with sigma = -1 all through, from its state at entry: (E2.1) as it stands.
struct Slipping {
  ContactNumbers<double> n;
  LayerMotion<double> layer;
  FreeMotion<double> own;

  Slipping(const ContactNumbers<double>& numbers, const LayerState<double>& entry)
      : n(numbers), layer(n.inertia, n.damping), own{} {
    const double theta = -n.half_angle;
    const double e =
        n.kinetic * ((layer.D * std::cos(theta) + layer.C * std::sin(theta)) * layer.response -
                     std::cos(n.half_angle));
    own = layer.start(layer.own_part({entry.e - e, entry.rate - forced_rate(theta)}));
  }

  double forced_rate(double theta) const {
    return n.kinetic * (layer.C * std::cos(theta) - layer.D * std::sin(theta)) * layer.response;
  }

  // -v_rel s / V0 by (E1.3)
  double margin(double x) const {
    const double theta = x - n.half_angle;
    const double rate = forced_rate(theta) + layer.at(own, x).rate;
    return n.stick_rate * (std::cos(theta) - n.speed_ratio) - rate;
  }
};

// Twenty roundings of the margin's terms: of speeds up to s (1 + V), of forces that the response amplifies, and of
// a phase that is rounded under the layer's own rate.
double rounding(const ContactNumbers<double>& n, const LayerMotion<double>& layer,
                const LayerState<double>& entry) {
  const double own =
      std::fabs(entry.e) + std::fabs(entry.rate) + n.kinetic * std::sqrt(1 + layer.response);
  const double rate = layer.has_inertia() ? 1 + layer.natural_frequency() + layer.C / layer.M : 1;
  return 4e-15 * (n.stick_rate * 2 + own * rate);
}

}  // namespace

TEST_CASE("a layer that slips all through returns to the given state at entry (E6.2)",
          "[core][contact][identity]") {
  Dice dice(81);
  int decayed = 0, remembers = 0;
  for (int i = 0; i < 1000; ++i) {
    ContactNumbers<double> n = any_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    // The slip margin falls by s for a unit of the speed, and that is all the speed does to a layer that slips:
    // at this one it is d.
    const SlipMargin any = slip_margin(n);
    const double d = n.stick_rate * dice.log_uniform(1e-6, 1e-1);
    n.speed_ratio += (any.value - d) / n.stick_rate;
    const SlipMargin margin = slip_margin(n);
    CAPTURE(i, n.inertia, n.damping, n.half_angle, n.speed_ratio);
    // A speed above one is rounded too, by eps V; twice, with that of the other margin.
    const double round = rounding(n, layer, margin.entry) * (1 + std::fabs(n.speed_ratio));
    CHECK(std::fabs(margin.value - d) <= 2 * round);
    CHECK(margin.slips);
    const Lap<double> lap = run_lap<double>(n, layer, {margin.entry});
    CHECK(lap.one_slip);
    CHECK(lap.zones == 1);
    (margin.entry.e == 0 && margin.entry.rate == 0 ? decayed : remembers) += 1;
    // Rounding of forces of order one, amplified by the response.
    CHECK(apart(layer, lap.next.layer, margin.entry) <= 1e-12 * std::sqrt(1 + layer.response));
  }
  CHECK(decayed > 100);
  CHECK(remembers > 500);
}

TEST_CASE("the slip margin is the least of a fine grid, no dip overlooked",
          "[core][contact][differential]") {
  Dice dice(82);
  int places[3] = {}, many_dips = 0;
  for (int i = 0; i < 400; ++i) {
    const ContactNumbers<double> n = any_contact(dice, i);
    const SlipMargin margin = slip_margin(n);
    const Slipping slipping(n, margin.entry);
    const int steps = 1000;
    const double length = 2 * n.half_angle, h = length / steps;
    std::vector<double> f;
    for (int k = 0; k <= steps; ++k) f.push_back(slipping.margin(k * h));
    double least = HUGE_VAL;
    int dips = 0;
    for (std::size_t k = 0; k < f.size(); ++k) {
      least = std::fmin(least, f[k]);
      dips += k > 0 && k + 1 < f.size() && f[k] < f[k - 1] && f[k] < f[k + 1];
    }
    many_dips += dips > 1;
    places[margin.exit ? 2 : margin.place > 0 ? 1 : 0] += 1;
    CAPTURE(i, n.inertia, n.damping, n.half_angle, n.speed_ratio, margin.place, length);
    const double round = rounding(n, slipping.layer, margin.entry);
    CHECK(margin.place >= 0);
    CHECK(margin.place <= length);
    CHECK(margin.exit == (margin.place == length));
    CHECK(std::fabs(margin.value - slipping.margin(margin.place)) <= round);
    // The search ends where no place is lower by more than 1e-14 of the margin's terms.
    CHECK(margin.value <= least + round + 1e-14 * (n.stick_rate * (1 + n.speed_ratio) + n.kinetic));
  }
  CHECK(places[0] > 20);
  CHECK(places[1] > 20);
  CHECK(places[2] > 20);
  CHECK(many_dips > 50);
}

TEST_CASE("the slip margin has the derivatives of the least margin in every number",
          "[core][contact][derivative]") {
  Dice dice(83);
  int places[3] = {};
  for (int i = 0; i < 300; ++i) {
    const ContactNumbers<double> n = i % 2 == 0 ? ringing_contact(dice) : heavy_contact(dice);
    const LayerMotion<double> layer(n.inertia, n.damping);
    const SlipMargin margin = slip_margin(n);
    CAPTURE(i, n.inertia, n.damping, n.half_angle, n.speed_ratio, margin.place, margin.exit);
    CHECK(std::fabs(slip_margin_at(n, margin) - margin.value) <= rounding(n, layer, margin.entry));
    const NumbersDual at = slip_margin_at(in_scalar<NumbersDual>(n), margin);
    double ContactNumbers<double>::*const list[] = {
        &ContactNumbers<double>::inertia,    &ContactNumbers<double>::damping,
        &ContactNumbers<double>::stick_rate, &ContactNumbers<double>::speed_ratio,
        &ContactNumbers<double>::half_angle, &ContactNumbers<double>::kinetic};
    bool one_place = true;
    double slope[6], twice[6];
    for (int k = 0; k < 6; ++k) {
      const auto moved = [&](double by) {
        ContactNumbers<double> m = n;
        m.*list[k] += by;
        set_half_angle(m, m.half_angle);
        const SlipMargin there = slip_margin(m);
        one_place =
            one_place && there.exit == margin.exit && std::fabs(there.place - margin.place) < 1e-2;
        return there.value;
      };
      const double d = 1e-5 * n.*list[k];
      slope[k] = (moved(d) - moved(-d)) / (2 * d);
      twice[k] = (moved(2 * d) - moved(-2 * d)) / (4 * d);
    }
    if (!one_place) continue;  // another dip is lower beside this one
    places[margin.exit ? 2 : margin.place > 0 ? 1 : 0] += 1;
    for (int k = 0; k < 6; ++k) {
      CAPTURE(k);
      // Differences over twice the step err four times as much: by three times the error of the others more.
      const double d = 1e-5 * n.*list[k];
      CHECK(std::fabs(at.d[k] - slope[k]) <=
            std::fabs(twice[k] - slope[k]) + 2 * rounding(n, layer, margin.entry) / d);
    }
  }
  CHECK(places[0] > 20);
  CHECK(places[1] > 20);
  CHECK(places[2] > 20);
}
