// SPDX-License-Identifier: Apache-2.0
#include "contact/short_slip.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// Simpson's rule with 2 n panels.
template <typename F>
double simpson(const F& f, double a, double b, int n) {
  const double h = (b - a) / (2 * n);
  double sum = f(a) + f(b);
  for (int k = 1; k < 2 * n; ++k) sum += (k % 2 ? 4 : 2) * f(a + k * h);
  return sum * h / 3;
}

struct OneZone {
  ContactNumbers<double> n;
  LayerMotion<double> layer;
  Harmonic<double> f;
  Phase<double> from, to;
  LayerState<double> h0;
  double length;

  OneZone(Dice& dice, int index, double longest)
      : n(random_contact(dice, index)),
        layer(n.inertia, n.damping),
        f(forced_response(n, layer, 1)),
        from{dice.uniform(-1, 0.2) * n.half_angle, {}},
        to{},
        h0(layer.own_part({dice.uniform(-0.2, 0.2), dice.uniform(-0.5, 0.5)})),
        length(std::min(longest, dice.uniform(0.1, 0.75) * n.half_angle)) {
    from.at = trig(from.theta);
    to = {from.theta + length, trig(from.theta + length)};
  }

  LayerState<double> own(double theta) const {
    return layer.at(layer.start(h0), theta - from.theta);
  }
  double rate(double theta) const { return own(theta).rate + f.slope(trig(theta)); }
  double pressure(double theta) const { return n.peak - trig(theta).versine; }
};

// Simpson resolves rates up to 400 with panels of 1e-4: (0.04)^4 / 180 = 1.4e-8 of an integrand that dies
// within them; the rates here stay below 100, for which it is 6e-11.
constexpr int kPanels = 10000;

}  // namespace

TEST_CASE("integrals over a slip zone follow from its end states (E5.1, E5.2)",
          "[core][contact][quadrature]") {
  Dice dice(31);
  int checked = 0;
  for (int i = 0; i < 100; ++i) {
    const OneZone zone(dice, i, 3);
    if (zone.layer.kind() == LayerKind::elastic) continue;
    if (zone.layer.kind() == LayerKind::overdamped && zone.layer.fast() < -100) continue;
    if (zone.layer.natural_frequency() > 100) continue;
    ++checked;
    const Moments<double> m(zone.from, zone.to);
    const SlipWork<double> work = slip_work(zone.n, zone.layer, zone.f, m, zone.from, zone.to,
                                            zone.h0, zone.own(zone.to.theta));
    const auto pressure_rate = [&](double x) { return zone.pressure(x) * zone.rate(x); };
    const auto square = [&](double x) { return zone.layer.C * zone.rate(x) * zone.rate(x); };
    const double scale = 1 + zone.layer.response;
    CHECK(std::fabs(work.rate_pressure - simpson(pressure_rate, zone.from.theta, zone.to.theta,
                                                 kPanels)) < 1e-9 * scale);
    CHECK(std::fabs(work.loss - simpson(square, zone.from.theta, zone.to.theta, kPanels)) <
          1e-9 * scale * scale);
  }
  CHECK(checked > 40);
}

TEST_CASE("the series of short slip zones (E5.3) agree with the closed forms where both are good",
          "[core][contact][differential]") {
  Dice dice(32);
  for (int i = 0; i < 300; ++i) {
    OneZone zone(dice, i, 0.3);
    if (zone.layer.kind() == LayerKind::elastic) continue;
    zone.length = std::min(zone.length, 2.4 / ShortSlip<double>::rate(zone.layer));
    zone.to = {zone.from.theta + zone.length, trig(zone.from.theta + zone.length)};
    const LayerState<double> h1 = zone.own(zone.to.theta);
    const LayerState<double> start{zone.h0.e + zone.f.at(zone.from.theta, zone.from.at),
                                   zone.h0.rate + zone.f.slope(zone.from.at)};
    const double fast =
        zone.layer.kind() == LayerKind::overdamped ? zone.layer.start(zone.h0).u : 0;
    const ShortSlip<double> series(zone.n, zone.layer, 1, zone.from, zone.length, start, fast);
    const Moments<double> m(zone.from, zone.to);
    const SlipWork<double> closed =
        slip_work(zone.n, zone.layer, zone.f, m, zone.from, zone.to, zone.h0, h1);
    const SlipWork<double> work = series.work(zone.from, zone.to);
    // The closed forms lose eps times the square of own and forced part, which the response sets.
    const double size = 1 + zone.layer.response, loss = 1e-14 * size * size;
    CHECK(std::fabs(work.rate_pressure - closed.rate_pressure) < loss);
    CHECK(std::fabs(work.loss - closed.loss) < 4 * loss);
    const LayerState<double> end = series.end();
    CHECK(std::fabs(end.e - h1.e - zone.f.at(zone.to.theta, zone.to.at)) < loss);
  }
}

TEST_CASE("the layer's own motion obeys its equation and loses its energy",
          "[core][contact][identity]") {
  Dice dice(33);
  for (int i = 0; i < 300; ++i) {
    const OneZone zone(dice, i, 3);
    if (!zone.layer.has_inertia()) continue;
    const bool modes = zone.layer.kind() == LayerKind::overdamped;
    const double rate = modes ? -zone.layer.fast() : ShortSlip<double>::rate(zone.layer);
    const double d = 1e-3 / rate;
    const double x = zone.from.theta + dice.uniform(0, 1) / rate + 2 * d;
    const LayerState<double> a = zone.own(x - d), c = zone.own(x), b = zone.own(x + d);
    // Differences over d of a motion with that rate err by 1e-6 / 6 of its acceleration.
    const double acceleration = (b.rate - a.rate) / (2 * d);
    const double terms =
        std::fabs(zone.layer.C * c.rate) + std::fabs(c.e) + std::fabs(zone.layer.M * acceleration);
    CHECK(std::fabs(zone.layer.M * acceleration + zone.layer.C * c.rate + c.e) <
          1e-5 * terms + 1e-12);
    CHECK(zone.layer.energy(b) <= zone.layer.energy(a) * (1 + 1e-13));
  }
}

TEST_CASE("the slowest decay is that of the slowest root of M x^2 + C x + 1",
          "[core][contact][closed_form]") {
  Dice dice(34);
  for (int i = 0; i < 1000; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const LayerMotion<double> layer(n.inertia, n.damping);
    if (layer.kind() == LayerKind::elastic) {
      CHECK(layer.slowest_decay() == HUGE_VAL);
      continue;
    }
    const std::complex<double> root =
        std::sqrt(std::complex<double>(n.damping * n.damping - 4 * n.inertia, 0));
    // Of the root that is nearer to zero, without a difference of nearly equal numbers.
    const double slowest = (2.0 / (n.damping + root)).real();
    // Near critical damping the root's square is a difference that keeps half of the digits.
    CHECK(std::fabs(layer.slowest_decay() - slowest) <= 1e-7 * slowest);
  }
}

TEST_CASE("layers hold what they have a memory for", "[core][contact][limit]") {
  const LayerState<double> any{0.3, 2};
  const LayerState<double> elastic = LayerMotion<double>(0, 0).own_part(any),
                           relaxing = LayerMotion<double>(0, 0.5).own_part(any),
                           inertial = LayerMotion<double>(0.1, 0.5).own_part(any);
  CHECK(elastic.e == 0);
  CHECK(elastic.rate == 0);
  CHECK(relaxing.e == any.e);
  CHECK(relaxing.rate == -any.e / 0.5);  // C e' + e = 0
  CHECK(inertial.e == any.e);
  CHECK(inertial.rate == any.rate);
}
