// SPDX-License-Identifier: Apache-2.0
#include "contact/short_slip.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

ContactNumbers<double> layer_numbers(double M, double C, double half_angle, double mu) {
  ContactNumbers<double> n{M, C, 0.3, 0.5, half_angle, 0, mu, mu, {}, false};
  set_half_angle(n, half_angle);
  return n;
}

// The series of a slip zone against the closed forms for its end states. Both are sums of squares and products of
// own and forced part, of the size that the response sets, with some ten roundings of 1.1e-16 of it.
void check_against_closed_forms(const ContactNumbers<double>& n, Dice& dice, double length) {
  const LayerMotion<double> layer(n.inertia, n.damping);
  const double sigma = dice.uniform(-1, 1) < 0 ? -1 : 1;
  const Harmonic<double> f = forced_response(n, layer, sigma);
  const double start = dice.uniform(-n.half_angle, n.half_angle - length);
  const Phase<double> from{start, trig(start)}, to{start + length, trig(start + length)};
  const LayerState<double> h0{dice.uniform(-0.5, 0.5),
                              dice.uniform(-0.5, 0.5) / std::sqrt(n.inertia)};
  const LayerState<double> h1 = layer.at(layer.start(h0), length);
  const LayerState<double> e0{h0.e + f.at(from.theta, from.at), h0.rate + f.slope(from.at)};
  const ShortSlip<double> series(n, layer, sigma, from, length, e0, 0);
  const SlipWork<double> closed =
      slip_work(n, layer, f, Moments<double>(from, to), from, to, h0, h1);
  const SlipWork<double> work = series.work(from, to);
  const LayerState<double> end = series.end();
  CAPTURE(n.inertia, n.damping, n.half_angle, length);
  const double size = 1 + layer.response, lost = 1.1e-15 * size * size;
  CHECK(std::fabs(work.rate_pressure - closed.rate_pressure) < lost);
  CHECK(std::fabs(work.loss - closed.loss) < 2 * lost);
  CHECK(std::fabs(end.e - h1.e - f.at(to.theta, to.at)) < lost);
}

}  // namespace

TEST_CASE("in a small contact a relaxing layer loses what the pressure dissipates in it (E5.3)",
          "[core][contact][closed_form]") {
  const double mu = 0.3;
  for (const double C : {0.1, 0.5, 2.0}) {
    const LayerMotion<double> layer(0, C);
    for (const double edge : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      const ContactNumbers<double> n = layer_numbers(0, C, edge, mu);
      const Phase<double> from{-edge, trig(-edge)}, to{edge, trig(edge)};
      for (const double sigma : {-1.0, 1.0}) {
        const SlipWork<double> work =
            ShortSlip<double>(n, layer, sigma, from, 2 * edge, {0, 0}, 0).work(from, to);
        // C e' + e = -sigma mu p with p = (edge^2 - theta^2) / 2: the strain e comes late by a share r = edge / C,
        // and to second order in it the integrals of p e' and C e'^2 are
        // -sigma mu (4 edge^5 / 15 C) (1 - 5 r / 6) and mu^2 (4 edge^5 / 15 C) (1 - 5 r / 3).
        const double share = edge / C;
        const double one = 4 * std::pow(edge, 5) / (15 * C);
        // What is left out is 2.3 r^2 at most, and edge^2 / 3 of the cosine's next term. Rounding is eps times
        // 30, since 1/3, 2/4 and 1/5 of the products' first terms leave a thirtieth.
        const double tolerance = 3 * share * share + edge * edge + 30 * 4e-16;
        CAPTURE(C, edge, sigma);
        CHECK(std::fabs(work.rate_pressure / (-sigma * mu * one * (1 - 5 * share / 6)) - 1) <=
              tolerance);
        CHECK(std::fabs(work.loss / (mu * mu * one * (1 - 5 * share / 3)) - 1) <= tolerance);
      }
    }
  }
}

TEST_CASE("in a small contact a layer with inertia is pushed as a free mass is (E5.3)",
          "[core][contact][closed_form]") {
  for (const double ratio : {0.2, 1.4, 1.6, 5.0}) {
    const double M = 0.5, C = 2 * ratio * std::sqrt(M), mu = 0.3;
    const LayerMotion<double> layer(M, C);
    for (const double edge : {1e-8, 1e-7, 1e-6, 1e-5, 1e-4, 1e-3}) {
      const ContactNumbers<double> n = layer_numbers(M, C, edge, mu);
      const Phase<double> from{-edge, trig(-edge)}, to{edge, trig(edge)};
      const Harmonic<double> f = forced_response(n, layer, -1);
      const double fast = layer.kind() == LayerKind::overdamped
                              ? layer.start({-f.at(from.theta, from.at), -f.slope(from.at)}).u
                              : 0;
      const ShortSlip<double> zone(n, layer, -1, from, 2 * edge, {0, 0}, fast);
      const SlipWork<double> work = zone.work(from, to);
      // M e'' = mu p, p = (edge^2 - theta^2) / 2: M e' / mu is what has been pushed so far, 2 edge^3 / 3 in all, so
      // the integral of p e' is half its square; that of e'^2 is 104 edge^7 / 315, with p = 2 edge^2 (u - u^2) and
      // e' M / mu = edge^3 (2 u^2 - 4 u^3 / 3) for theta = edge (2 u - 1).
      const double pushed = 2 * std::pow(edge, 3) / 3;
      // Damping takes up to a share 2 edge C / M of the rate, twice that of its square, and the spring and the
      // cosine's next term take shares of edge^2 / M; rounding is 30 eps as above.
      const double tolerance = 4 * edge * C / M + 4 * edge * edge / M + 30 * 4e-16;
      CAPTURE(edge, ratio);
      CHECK(std::fabs(zone.end().rate / (mu / M * pushed) - 1) <= tolerance);
      CHECK(std::fabs(work.rate_pressure / (0.5 * mu / M * pushed * pushed) - 1) <= tolerance);
      CHECK(std::fabs(work.loss / (C * mu * mu / (M * M) * 104 * std::pow(edge, 7) / 315) - 1) <=
            tolerance);
    }
  }
}

TEST_CASE("the series (E5.3) resolve layers damped past their critical damping",
          "[core][contact][differential]") {
  Dice dice(64);
  for (int i = 0; i < 300; ++i) {
    const double M = dice.log_uniform(1e-4, 1), C = 2 * dice.uniform(1, 1.499) * std::sqrt(M);
    // The larger root of M x^2 - C x + 1 is below C / M.
    const double rate = std::max({C / M, 1 / std::sqrt(M), 1.0}), length = 2.4 / rate;
    const double half_angle = std::max(dice.uniform(0.5, 1) * length, dice.uniform(0.1, 1.5));
    check_against_closed_forms(layer_numbers(M, C, half_angle, dice.uniform(0.05, 0.6)), dice,
                               length);
  }
}

TEST_CASE("the series (E5.3) resolve zones as long as the wave lets them be",
          "[core][contact][differential]") {
  Dice dice(65);
  double longest = 0;
  for (int i = 0; i < 300; ++i) {
    const double M = dice.uniform(0.3, 0.7), C = dice.uniform(0.05, 0.5);
    const double rate = std::max({C / M, 1 / std::sqrt(M), 1.0});
    const double length = std::min(2.4 / rate, 2.4);
    longest = std::max(longest, length);
    check_against_closed_forms(layer_numbers(M, C, 1.5, dice.uniform(0.05, 0.6)), dice, length);
  }
  CHECK(longest > 1.9);
}
