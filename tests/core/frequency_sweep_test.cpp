// SPDX-License-Identifier: Apache-2.0
#include "support/driven_motors.hpp"
#include "support/two_modes.hpp"

#include <catch2/catch.hpp>

#include <twum/core/frequency_response.hpp>
#include <twum/core/motor.hpp>

#include <cmath>
#include <complex>

// Turns of the response against an integration in time of the two modes while the frequency of the drive moves (D5.3).
namespace {

using namespace twum;
using namespace twum::test;

constexpr double kSpeed = 0.3;  // of the rotor [rad/s]
constexpr double kVoltage = 65;
// So slowly turned a rotor makes the stator squeal, which is not what is tested here.
constexpr double kBackwardDamping = 200;  // [N s/m], five times that of the modes
constexpr int kPeriodsAtOnce = 10;

// Frequency at which the amplitude has passed a value while the drive sweeps.
double jump_at(double from, double rate, const WaveState& begin, double passed, bool falling) {
  TwoModes modes(driven_motor(kVoltage, from), kSpeed);
  modes.damp_backward_waves(kBackwardDamping);
  modes.set_wave(begin.amplitude, begin.phase_lag);
  modes.run(200);
  for (double f = from; std::fabs(f - from) < 500; f += rate * kPeriodsAtOnce) {
    modes.set_frequency(f);
    modes.run(kPeriodsAtOnce);
    if ((std::abs(modes.wave()) < passed) == falling) return f;
  }
  return 0;
}

// A slow sweep passes a turn by a distance that goes with the 2/3 power of its rate: two rates tell the turn.
struct Jumps {
  double fast, slow;
  double limit() const { return slow - (fast - slow) / (std::pow(2.0, 2.0 / 3) - 1); }
};

}  // namespace

TEST_CASE("slow sweeps of two modes jump where the response turns (D5.3)",
          "[.long][core][driven][brute_force]") {
  const FrequencyResponse response(driven_motor(kVoltage), {Argument::speed, kSpeed});
  const auto branches = response.branches();
  REQUIRE(branches.size() == 3);
  const double start = branches[0].points.back().frequency,
               pull_out = branches[2].points.front().frequency;
  constexpr double kRate = 300.0 / 4000;  // [Hz per period]
  const auto wave = [](double f, bool large) {
    const auto states = Motor(driven_motor(kVoltage, f)).wave_states(kSpeed);
    return large ? states.back() : states.front();
  };
  const double above = pull_out + 60, below = start - 60;
  const Jumps down{jump_at(above, -kRate, wave(above, true), 0.8e-6, true),
                   jump_at(above, -0.5 * kRate, wave(above, true), 0.8e-6, true)};
  const Jumps up{jump_at(below, kRate, wave(below, false), 0.3e-6, false),
                 jump_at(below, 0.5 * kRate, wave(below, false), 0.3e-6, false)};
  CAPTURE(pull_out, down.fast, down.slow, start, up.fast, up.slow);
  // The sweep passes the turn before it jumps, and less so the slower it is.
  CHECK(down.fast < down.slow);
  CHECK(down.slow < pull_out);
  CHECK(up.fast > up.slow);
  CHECK(up.slow > start);
  // What the 2/3 power leaves is of the order of the rate times the periods of a jump, some hundred: a quarter of the distance. The
  // integration's own error of 1e-3 in the force moves the turns by as much of their width, 3.3 kHz.
  CHECK(down.limit() == Approx(pull_out).margin(6));
  CHECK(up.limit() == Approx(start).margin(6));
}
