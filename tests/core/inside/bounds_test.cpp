// SPDX-License-Identifier: Apache-2.0
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <vector>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

// 1e-12: samples and bounds are sums of a few terms of their own size.
constexpr double kSlack = 1 + 1e-12;

TEST_CASE("the bounds of a slip zone (E4.1, E4.2, E4.3, E4.4) hold at every later place",
          "[core][events][identity]") {
  Dice dice(11);
  for (int i = 0; i < 500; ++i) {
    const ContactNumbers<double> n = random_contact(dice, i);
    const RandomSlip slip(n, dice);
    std::vector<CurveSample> samples;
    for (int k = 0; k <= 60; ++k) samples.push_back(slip.curve().sample(slip.length * k / 60));
    for (std::size_t k = 0; k < samples.size(); ++k) {
      for (std::size_t later = k; later < samples.size(); ++later) {
        REQUIRE(std::fabs(samples[later].f2) <= samples[k].l2 * kSlack);
        REQUIRE(std::fabs(samples[later].f3) <= samples[k].l3 * kSlack);
      }
    }
  }
}

TEST_CASE("the slip curve (E2.1, E2.2) has the derivatives it states",
          "[core][events][derivative]") {
  Dice dice(12);
  for (int i = 0; i < 300; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const SlipCurve curve = slip.curve();
    const double x = dice.uniform(0.1, 0.9) * slip.length;
    const CurveSample c = curve.sample(x);
    // Central differences over d err by l3 d^2 / 6 and by rounding of f over d.
    const double d = 1e-4 * std::min(1.0, std::sqrt((1 + std::fabs(c.f)) / c.l3));
    const CurveSample a = curve.sample(x - d), b = curve.sample(x + d);
    const double rounding = 4e-15 * (1 + std::fabs(c.f) + std::sqrt(c.l2)) / d;
    CHECK(std::fabs((b.f - a.f) / (2 * d) - c.f1) <= a.l3 * d * d / 3 + rounding);
    CHECK(std::fabs((b.f1 - a.f1) / (2 * d) - c.f2) <=
          2 * a.l3 * d + rounding * (1 + std::fabs(c.f1) + c.l2));
  }
}

TEST_CASE("the skip (E4.6) passes no zero of the slip curve", "[core][events][identity]") {
  Dice dice(13);
  int skips = 0;
  for (int i = 0; i < 500; ++i) {
    const RandomSlip slip(random_contact(dice, i), dice);
    const double x = dice.uniform(0, 0.5) * slip.length;
    const CurveSample c = slip.curve().sample(x);
    if (!(c.skip > 0)) continue;
    ++skips;
    const double reach = std::min(c.skip, slip.length - x);
    for (int k = 0; k < 200; ++k) REQUIRE(slip.curve().sample(x + reach * k / 200).f > 0);
  }
  CHECK(skips > 50);
}

TEST_CASE("the layer's own motion falls as far below zero as its depth (E4.9), and not farther",
          "[core][events][closed_form]") {
  Dice dice(17);
  int in_a_trough = 0, at_once = 0;
  for (int i = 0; i < 500; ++i) {
    // exp(-zeta x) cos(beta x - psi), with the layer made for it: 1 / M = zeta^2 + beta^2, C = 2 zeta M.
    const double beta = dice.log_uniform(0.3, 30), zeta = beta * dice.log_uniform(1e-3, 3);
    const double psi = dice.uniform(-3.1, 3.1), inertia = 1 / (zeta * zeta + beta * beta);
    const LayerMotion<double> layer(inertia, 2 * zeta * inertia);
    const auto y = [&](double x) { return std::exp(-zeta * x) * std::cos(beta * x - psi); };
    const double depth = layer.depth(y(0), beta * std::sin(psi) - zeta * std::cos(psi));
    double lowest = 0;
    constexpr int kSteps = 4000;  // over more than a turn
    for (int k = 0; k <= kSteps; ++k) lowest = std::min(lowest, y(7 / beta * k / kSteps));
    (lowest < y(0) ? in_a_trough : at_once) += 1;
    // Between two steps of d = 7 / beta / 4000 y is lower than at both by y'' d^2 / 8 at most; y'' is below
    // 1 / M <= 10 beta^2.
    CAPTURE(beta, zeta, psi);
    CHECK(depth >= -lowest * (1 - 1e-12));
    CHECK(depth <= -lowest + 10 * (7.0 / kSteps) * (7.0 / kSteps) / 8 + 1e-12);
  }
  CHECK(in_a_trough > 100);
  CHECK(at_once > 50);
  // Two modes do not oscillate.
  CHECK(LayerMotion<double>(0.1, 2).depth(1.0, 0.0) == HUGE_VAL);
  CHECK(LayerMotion<double>(0, 2).depth(1.0, 0.0) == HUGE_VAL);
}

TEST_CASE("the bounds of the stick curve (E2.4, E4.5) hold everywhere",
          "[core][events][identity]") {
  Dice dice(14);
  for (int i = 0; i < 200; ++i) {
    const Harmonic<double> f{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1),
                             dice.uniform(-1, 1)};
    const double start = dice.uniform(-3, 0);
    const StickCurve curve(f, start, trig(start));
    const CurveSample first = curve.first();
    for (int k = 0; k <= 50; ++k) {
      const CurveSample c = curve.sample(3.0 * k / 50);
      REQUIRE(std::fabs(c.f2) <= first.l2 * kSlack);
      REQUIRE(std::fabs(c.f2 - first.f2) <= first.l3 * 3.0 * k / 50 + 1e-15);
    }
  }
}

namespace {

// Sinusoid and line that leave their start above zero, or rising from it.
struct RandomStick {
  explicit RandomStick(Dice& dice)
      : f{dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1), dice.uniform(-1, 1)},
        start(dice.uniform(-3, 0)),
        length(dice.uniform(0.01, 3.13)),
        order(dice.uniform(0, 1) < 0.5 ? StartOrder::zero : StartOrder::positive) {
    if (order == StartOrder::zero) f.k0 -= f.at(start, trig(start));
  }
  StickCurve curve() const { return {f, start, trig(start)}; }
  StickCurve::Glance glance() const { return curve().glance(length, order, trig(start + length)); }

  Harmonic<double> f;
  double start, length;
  StartOrder order;
};

}  // namespace

TEST_CASE("where a glance at a stick zone reports one zero, there is exactly one (E4.7)",
          "[core][events][identity]") {
  Dice dice(15);
  int convex_end = 0, convex_start = 0, rising = 0, found = 0;
  for (int i = 0; i < 20000; ++i) {
    const RandomStick stick(dice);
    if (stick.glance() != StickCurve::Glance::one_zero) continue;
    const StickCurve curve = stick.curve();
    ++found;
    convex_end += curve.sample(stick.length).f2 > 0;
    convex_start += curve.first().f2 > 0;
    rising += stick.order == StartOrder::zero;
    const double zero = curve.only_zero(stick.length, kNoZero);
    REQUIRE(zero > 0);
    REQUIRE(zero < stick.length);
    // The sign changes at the zero, and on a fine grid nowhere else: what lies within a step of it, or of
    // the start where f = 0, is left out.
    const double step = stick.length / 500;
    for (int k = 1; k <= 500; ++k) {
      const double x = k * step;
      if (std::fabs(x - zero) > step) REQUIRE((curve.sample(x).f > 0) == (x < zero));
    }
    // A root is good to rounding of the terms, each below 1 + 3 + 2 + 1, over the slope; from a place
    // nearby it is the same.
    const CurveSample c = curve.sample(zero);
    REQUIRE(std::fabs(c.f) <= 7 * 4e-16 + 1e-15 * std::fabs(c.f1));
    const double near = curve.only_zero(stick.length, zero * (1 + 1e-3));
    REQUIRE(std::fabs(near - zero) * std::fabs(c.f1) <= 2 * (7 * 4e-16 + 1e-15 * std::fabs(c.f1)));
  }
  CHECK(found > 1000);
  CHECK(convex_end > 100);
  CHECK(convex_start > 100);
  CHECK(rising > 100);
}

TEST_CASE("where a glance at a stick zone reports no zero, there is none (E4.8)",
          "[core][events][identity]") {
  Dice dice(16);
  int kinds[2][2] = {};
  for (int i = 0; i < 20000; ++i) {
    const RandomStick stick(dice);
    if (stick.glance() != StickCurve::Glance::no_zero) continue;
    const StickCurve curve = stick.curve();
    ++kinds[curve.first().f2 > 0][curve.sample(stick.length).f2 > 0];
    for (int k = 1; k <= 500; ++k) REQUIRE(curve.sample(stick.length * k / 500).f > 0);
  }
  for (const auto& [concave_end, convex_end] : kinds) {
    CHECK(concave_end > 100);
    CHECK(convex_end > 100);
  }
}

TEST_CASE("a glance decides nothing where its bounds do not hold", "[core][events][range]") {
  // cos x - 0.5 over more than half a turn, and a curve that starts below zero.
  const StickCurve turn({0.5, 0, -1, 0}, 0, trig(0.0));
  CHECK(turn.glance(3.15, StartOrder::positive, trig(3.15)) == StickCurve::Glance::unknown);
  CHECK(turn.glance(3.13, StartOrder::positive, trig(3.13)) == StickCurve::Glance::one_zero);
  CHECK(turn.glance(1, StartOrder::double_zero, trig(1.0)) == StickCurve::Glance::unknown);
  const StickCurve below({-0.5, 0, -1, 0}, 0, trig(0.0));
  CHECK(below.glance(1, StartOrder::positive, trig(1.0)) == StickCurve::Glance::unknown);
}
