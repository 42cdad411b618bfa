// SPDX-License-Identifier: Apache-2.0
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// The fastest rate of a layer's own motion, or the wave's.
double rate_of(const LayerMotion<double>& layer) {
  if (layer.has_inertia()) return std::max({1.0, layer.C / layer.M, 1 / std::sqrt(layer.M)});
  return layer.kind() == LayerKind::elastic ? 1 : std::max(1.0, 1 / layer.C);
}

}  // namespace

TEST_CASE("the skip (E4.6) sees a dip between two places above the bound",
          "[core][events][closed_form]") {
  // f = 0.85 + cos theta of a layer without motion of its own, over 3.9 rad: positive at both ends, and falling
  // at both.
  const LayerMotion<double> layer(0, 0);
  const double start = -0.1, length = 3.9;
  const SlipCurve curve(layer, {0, 0}, {1.85, 0, -1, 0}, 1, start, trig(start), length,
                        trig(start + length));
  REQUIRE(curve.first().f > 0);
  REQUIRE(curve.sample(length).f > 0);
  long work = 0;
  const double zero = first_zero(curve, length, StartOrder::positive, work, 1000);
  // f is made of numbers up to 1.85, a rounding of each, over a slope of 0.53; theta and the zero have one.
  CHECK(std::fabs(zero - (std::acos(-0.85) - start)) <= 4e-15);
}

TEST_CASE("the bounds at critical damping (E4.1, E4.2, E4.3) are the energies of its derivatives",
          "[core][events][closed_form]") {
  Dice dice(66);
  for (int i = 0; i < 300; ++i) {
    // h = (a + b x) exp(-k x) for C = 2 / k, M = 1 / k^2, all of them exact.
    const double k = std::exp2(i % 4), a = dice.uniform(-1, 1), b = dice.uniform(-1, 1) * k;
    const LayerMotion<double> layer(1 / (k * k), 2 / k);
    const Harmonic<double> slow{dice.uniform(-1, 1), 0, dice.uniform(-1, 1), dice.uniform(-1, 1)};
    const double sigma = i % 2 == 0 ? 1 : -1, start = dice.uniform(-2, 0);
    const SlipCurve curve(layer, {a, b - k * a}, slow, sigma, start, trig(start), 2,
                          trig(start + 2));
    const double x = dice.uniform(0, 1) / k;
    const CurveSample c = curve.sample(x);
    double own[6];  // the derivatives h^(m) = (-k)^m (a + b x - m b / k) exp(-k x)
    for (int m = 0; m < 6; ++m)
      own[m] = std::pow(-k, m) * (a + b * x - m * b / k) * std::exp(-k * x);
    const auto bound = [&](int m) { return std::hypot(own[m], own[m + 1] / k); };
    const double swing = std::hypot(slow.kw, slow.ks), at = start + x;
    const double slope = sigma * (slow.kw * std::sin(at) + slow.ks * std::cos(at)),
                 curvature = sigma * (slow.kw * std::cos(at) - slow.ks * std::sin(at));
    // The equation gives each derivative from the two below it and adds a few roundings of terms that are up to
    // 3 + 7 times k^m: 1e-13 of k^m is more than a hundred of them.
    const double one = 1e-13 * k;
    CHECK(std::fabs(c.f1 - (slope + sigma * own[2])) <= one * k);
    CHECK(std::fabs(c.f2 - (curvature + sigma * own[3])) <= one * k * k);
    CHECK(std::fabs(c.f3 - (sigma * own[4] - slope)) <= one * k * k * k);
    CHECK(std::fabs(c.l2 - (swing + bound(3))) <= one * k * k);
    CHECK(std::fabs(c.l3 - (swing + bound(4))) <= one * k * k * k);
  }
}

TEST_CASE("value and derivatives of the slip curve (E2.2) come alone as they come with bounds",
          "[core][events][identity]") {
  Dice dice(67);
  for (int i = 0; i < 500; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const double x = dice.uniform(0, 1) * slip.length;
    const CurveSample c = slip.curve().sample(x), t = slip.curve().terms(x);
    // To the bit: a march that polishes by one may go on by the other.
    CHECK(t.f == c.f);
    CHECK(t.f1 == c.f1);
    CHECK(t.f2 == c.f2);
    CHECK(t.f3 == c.f3);
  }
}

TEST_CASE("the slip curve starts where its motion starts", "[core][events][identity]") {
  Dice dice(68);
  int skips = 0, free = 0;
  for (int i = 0; i < 500; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const CurveSample a = slip.curve().first(), b = slip.curve().sample(0);
    // The motion after x = 0 differs from that told at the start by a few roundings of its own derivatives, and
    // so do the phase's sine and cosine: each is some 1e-16 of a bound of what is above it.
    const double rate = rate_of(slip.layer);
    const double one = 1e-14 * (1 + a.l3 + rate * (a.l2 + rate * std::fabs(a.f)));
    CAPTURE(i, slip.layer.M, slip.layer.C);
    CHECK(std::fabs(a.f - b.f) <= one);
    CHECK(std::fabs(a.f1 - b.f1) <= one);
    CHECK(std::fabs(a.f2 - b.f2) <= one);
    CHECK(std::fabs(a.f3 - b.f3) <= one);
    CHECK(std::fabs(a.l2 - b.l2) <= one);
    CHECK(std::fabs(a.l3 - b.l3) <= one);
    if (a.skip == kNoZero) {
      ++free;
      CHECK(b.skip == kNoZero);
      continue;
    }
    skips += a.skip > 0;
    // A rounding r of the bound, 1e-13 and less, moves an arc cosine by sqrt(2 r) at most.
    CHECK(std::fabs(a.skip - b.skip) <= 1e-6);
  }
  CHECK(skips > 20);
  CHECK(free > 20);
}

TEST_CASE("the third derivatives of slip and stick curves (E2.2, E2.4) are those of their second",
          "[core][events][derivative]") {
  Dice dice(69);
  for (int i = 0; i < 500; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const double rate = rate_of(slip.layer), d = 1e-3 / rate;
    const double x = dice.uniform(0.1, 0.9) * slip.length / rate + 2 * d;
    const SlipCurve curve = slip.curve();
    const CurveSample a = curve.sample(x - d), c = curve.sample(x), b = curve.sample(x + d);
    // A derivative two orders higher is at most 5 rate^2 times as large by the energies of (E4.3), and the
    // difference errs by d^2 / 6 of that, below 1e-6 of the bound. Rounding of f'' is that of h' and h'' in
    // it, with factors of rate^2 and rate.
    const LayerState<double> own = slip.layer.at(slip.motion, x - d);
    const double terms = 1 + rate * rate * (std::fabs(own.rate) + rate * std::fabs(own.e));
    CAPTURE(i, slip.layer.M, slip.layer.C, x);
    CHECK(std::fabs((b.f2 - a.f2) / (2 * d) - c.f3) <= 1e-6 * a.l3 + 4e-15 * terms / d);
  }
  for (int i = 0; i < 200; ++i) {
    const Harmonic<double> f{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1),
                             dice.uniform(-1, 1)};
    const double start = dice.uniform(-3, 0), x = dice.uniform(0.1, 3), d = 1e-3;
    const StickCurve curve(f, start, trig(start));
    const CurveSample a = curve.sample(x - d), c = curve.sample(x), b = curve.sample(x + d);
    // d^2 / 6 of a sinusoid's fifth derivative, and rounding of f'' of order one over d.
    CHECK(std::fabs((b.f2 - a.f2) / (2 * d) - c.f3) <= 2e-7 * c.l3 + 1e-12);
  }
}
