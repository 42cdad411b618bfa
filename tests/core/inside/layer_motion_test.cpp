// SPDX-License-Identifier: Apache-2.0
#include "contact/layer_motion.hpp"
#include "random_contact.hpp"

#include <catch2/catch.hpp>

#include <cmath>

using namespace twum;
using namespace twum::contact;
using namespace twum::test;

namespace {

// exp(-zeta x) cos(beta x) and exp(-zeta x) sin(beta x) / beta in long double, by power series in
// beta^2 x^2 of which 20 terms leave nothing below 1.
struct ExactMotion {
  long double decay, square, x, cosine{0}, sine{0};

  ExactMotion(long double M, long double C, long double length)
      : decay(C / (2 * M)), square(1 / M - decay * decay), x(length) {
    const long double q = square * x * x;
    long double even = 1, odd = 1;
    for (int k = 0; k < 20; ++k) {
      cosine += even;
      sine += odd;
      even *= -q / static_cast<long double>((2 * k + 1) * (2 * k + 2));
      odd *= -q / static_cast<long double>((2 * k + 2) * (2 * k + 3));
    }
    const long double envelope = std::exp(-decay * x);
    cosine *= envelope;
    sine *= envelope * x;
  }

  // The motion h with h(0) = u, h'(0) = w.
  double at(double u, double w) const {
    return static_cast<double>(u * cosine + (w + decay * u) * sine);
  }
  double rate_at(double u, double w) const {
    const long double glide = w + decay * u;
    return static_cast<double>((glide - decay * u) * cosine - (square * u + decay * glide) * sine);
  }
};

}  // namespace

TEST_CASE("the layer's own motion keeps its digits through critical damping (T5.1)",
          "[core][contact][closed_form]") {
  const double M = 4, x = 6;
  Dice dice(63);
  int oscillates = 0, creeps = 0;
  for (int i = 0; i < 2000; ++i) {
    // beta^2 x^2 = (1 - ratio^2) x^2 / M, with every second case at most where the series ends, 0.02.
    const double reach = i % 2 == 0 ? 0.9 : 0.02;
    const double turn = dice.uniform(-reach, reach);
    const double C = 2 * std::sqrt(M * (1 - turn * M / (x * x)));
    const LayerMotion<double> layer(M, C);
    REQUIRE(layer.kind() == LayerKind::oscillating);
    const ExactMotion exact(M, C, x);
    (exact.square > 0 ? oscillates : creeps) += 1;
    CAPTURE(i, turn, C);
    const LayerState<double> moved = layer.at({1, 0}, x), pushed = layer.at({0, 1}, x);
    // In units of the envelope exp(-zeta x), zeta x = 3, everything is made of cos(beta x) and sin(beta x) / (beta x),
    // of order one here. The argument of exp is rounded twice, 7e-16; beta^2 = 1 / M - zeta^2 is a difference
    // of numbers 1/4, whose rounding, times x^2 / 2, leaves 5e-16 of the cosine and a third of that of the sine;
    // the sum takes 1e-15 more. What multiplies them is 1 and zeta x where the layer starts from a strain, x or 1 +
    // zeta x from a rate.
    const double envelope = 3e-15 * static_cast<double>(std::exp(-exact.decay * x));
    const double decay = static_cast<double>(exact.decay);
    CHECK(std::fabs(moved.e - exact.at(1, 0)) <= envelope * (1 + decay * x));
    CHECK(std::fabs(pushed.e - exact.at(0, 1)) <= envelope * x);
    CHECK(std::fabs(moved.rate - exact.rate_at(1, 0)) <= envelope * decay * (1 + decay * x));
    CHECK(std::fabs(pushed.rate - exact.rate_at(0, 1)) <= envelope * (1 + decay * x));
  }
  CHECK(oscillates > 500);
  CHECK(creeps > 500);
}
