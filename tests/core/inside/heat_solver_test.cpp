// SPDX-License-Identifier: Apache-2.0
// The search for steady temperatures, with losses that are known in closed form, and what it costs for a motor.
#include <catch2/catch.hpp>

#include "heat/heat_state.hpp"
#include "metrics/load_losses.hpp"
#include "support/heat_motors.hpp"

#include <cmath>
#include <memory>

using namespace twum;
using namespace twum::core;
using namespace twum::test;

namespace {

// One node of 0.25 W/K and a time constant of 600 s with the loss f(T), at 300 K.
struct Loss {
  std::function<double(double)> at, slope;
};
HeatSolver one_node_with(const Loss& loss) {
  HeatNetwork network;
  network.one_node = true;
  network.stator_ambient = 0.25, network.stator_capacity = 150;
  return HeatSolver({network, 300, [loss](const NodeTemperatures& x) {
                       WarmLosses w;
                       w.p[2] = loss.at(x[0]);
                       w.slope[2][0] = loss.slope(x[0]);
                       return w;
                     }});
}

// A motor's losses, counted.
struct Counted {
  HeatSolver solver;
  std::shared_ptr<int> searched, followed;
};
Counted counted(const MotorDesign& design, const LoadPoint& load) {
  Counted counted{HeatSolver(heat_problem(design, network_of(design), load)),
                  std::make_shared<int>(0), std::make_shared<int>(0)};
  const LoadLosses losses(design, load);
  counted.solver = HeatSolver(
      {network_of(design), design.thermal->ambient,
       [losses, points = counted.searched](const NodeTemperatures& x) {
         ++*points;
         return losses.at(x);
       },
       [losses, points = counted.followed](const NodeTemperatures& x, const LoadWave& known) {
         ++*points;
         return losses.near(x, known);
       }});
  return counted;
}

}  // namespace

TEST_CASE("losses that are linear in the temperature have their closed form (H3.2, H3.3)",
          "[core][heat][closed-form]") {
  // 8 W + 0.1 W/K (T - 300 K): rise 8 / (0.25 - 0.1), gain 0.1 / 0.25, and the slower approach (0.25 - 0.1) / 150 J/K
  const HeatSolver solver =
      one_node_with({[](double T) { return 8 + 0.1 * (T - 300); }, [](double) { return 0.1; }});
  const SteadyState steady = solver.from_cold();
  REQUIRE(steady.ok());
  CHECK(std::fabs(steady.state.x[0] - 300 - 8 / 0.15) <= 1e-10);
  CHECK(std::fabs(steady.gain - 0.4) <= 1e-14);
  CHECK(std::fabs(steady.slowest + 0.15 / 150) <= 1e-15);
  // The warm-up is a single exponential, of which a step of (H4.3) is exact.
  const HeatState later = solver.advanced(solver.cold(), 500, 1e-3);
  CHECK(std::fabs(later.theta[0] + 8 / 0.15 * std::expm1(-500 * 0.15 / 150)) <= 1e-9);
}

TEST_CASE("of several steady states the cold motor reaches the first (H3.2)",
          "[core][heat][closed-form]") {
  // Losses of 0.25 W/K (rise) + g with g = 2e-4 (40 - rise) (70 - rise) (120 - rise) / 40: steady at rises of 40, 70 and 120 K, the
  // middle one unstable.
  const auto g = [](double r) { return 5e-6 * (40 - r) * (70 - r) * (120 - r); };
  const auto dg = [](double r) {
    return -5e-6 * ((70 - r) * (120 - r) + (40 - r) * (120 - r) + (40 - r) * (70 - r));
  };
  const HeatSolver solver = one_node_with({[=](double T) { return 0.25 * (T - 300) + g(T - 300); },
                                           [=](double T) { return 0.25 + dg(T - 300); }});
  const SteadyState first = solver.from_cold();
  REQUIRE(first.ok());
  CHECK(std::fabs(first.state.x[0] - 340) <= 1e-8);
  const SteadyState middle = solver.near({369, 369, 369});
  CHECK(middle.state.status == MetricStatus::thermally_unstable);
  CHECK(std::fabs(middle.state.x[0] - 370) <= 1e-8);
  CHECK(middle.gain > 1);
  CHECK(std::fabs(solver.near({425, 425, 425}).state.x[0] - 420) <= 1e-8);
  // the approach in time ends there, too, with a time constant of 150 J/K / (5e-6 * 30 * 80 W/K), 12,500 s
  CHECK(std::fabs(solver.advanced(solver.cold(), 300000, 1e-3).theta[0] - 40) <= 1e-2);
}

TEST_CASE("losses that outgrow every way out never settle (H3.2)", "[core][heat][property]") {
  const HeatSolver solver =
      one_node_with({[](double T) { return 5 + 0.3 * (T - 300); }, [](double) { return 0.3; }});
  CHECK_FALSE(solver.from_cold().ok());
}

TEST_CASE("exp and phi of a matrix are those of its eigenvalues (H4.3)",
          "[core][heat][closed-form]") {
  // V diag V^-1 with V = [1 1 0; 0 1 1; 1 0 1], whose inverse is [1 -1 1; 1 1 -1; -1 1 1] / 2
  const Matrix3 V{{{1, 1, 0}, {0, 1, 1}, {1, 0, 1}}},
      inverse_of_V{{{0.5, -0.5, 0.5}, {0.5, 0.5, -0.5}, {-0.5, 0.5, 0.5}}};
  const Vector3 rates{-0.3, -7, 1.2};
  const auto of = [&](auto f) {
    Matrix3 d{};
    for (std::size_t i = 0; i < 3; ++i) d[i][i] = f(rates[i]);
    return V * (d * inverse_of_V);
  };
  const Matrix3 a = of([](double x) { return x; });
  const Exponential found = exponential(a);
  const Matrix3 exp = of([](double x) { return std::exp(x); }),
                phi = of([](double x) { return std::expm1(x) / x; });
  const Eigenvalues e = eigenvalues(a);
  Vector3 sorted = e.real;
  std::sort(sorted.begin(), sorted.end());
  CHECK(e.imaginary == 0);
  CHECK(std::fabs(sorted[0] + 7) + std::fabs(sorted[1] + 0.3) + std::fabs(sorted[2] - 1.2) <=
        1e-13);
  const Matrix3 unit = inverse(a) * a;
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) {
      // six squarings of a series that is good to rounding
      CHECK(std::fabs(found.exp[i][j] - exp[i][j]) <= 1e-13);
      CHECK(std::fabs(found.phi[i][j] - phi[i][j]) <= 1e-13);
      CHECK(std::fabs(unit[i][j] - kIdentity3[i][j]) <= 1e-13);
    }
  // a turn by 1 rad about an axis: 1 and exp(+-i)
  const Eigenvalues turn =
      eigenvalues({{{std::cos(1), -std::sin(1), 0}, {std::sin(1), std::cos(1), 0}, {0, 0, 0.2}}});
  CHECK(std::fabs(turn.real[0] - 0.2) <= 1e-14);
  CHECK(std::fabs(turn.real[1] - std::cos(1)) <= 1e-14);
  CHECK(std::fabs(turn.imaginary - std::sin(1)) <= 1e-14);
}

TEST_CASE("a steady state of a usual motor costs at most six points with gradients (H3.3)",
          "[core][heat][cost]") {
  for (const double torque : {0.0, 0.2, 0.5, 0.8}) {
    CAPTURE(torque);
    const Counted at = counted(with_table(warm_motor()), heat_load(torque));
    REQUIRE(at.solver.from_cold().ok());
    CHECK(*at.searched + *at.followed <= 6);
    CHECK(*at.searched <=
          3);  // the cold motor, the answer, and one between them where the way bends
  }
}

TEST_CASE("a wave that is followed to other temperatures is the one that a search finds (H3.3)",
          "[core][heat][identity]") {
  Uniform random(3);
  int followed = 0;
  for (int i = 0; i < 60; ++i) {
    MotorDesign design = with_table(warm_motor());
    design.stator.voltage = random(110, 160);
    design.preload = random(120, 190);
    design.stator.radial_slices = i % 3 == 0 ? 4 : 1;
    const LoadPoint load =
        i % 2 == 0 ? heat_load(random(0.05, 0.6)) : LoadPoint{Argument::speed, random(5, 14)};
    const LoadLosses losses(design, load);
    const double cold = kZero + 20, warm = cold + random(1, 40);
    const WarmLosses first = losses.at({cold, cold, cold});
    if (!first.wave) continue;
    const auto near = losses.near({warm, warm, warm}, *first.wave);
    const WarmLosses searched = losses.at({warm, warm, warm});
    if (!near || searched.status != MetricStatus::ok) continue;
    ++followed;
    // Both solve for the wave to 1e-12; losses and slopes move with it by less than a hundred times that. Slices come from the
    // same rule.
    for (std::size_t k = 0; k < kSources; ++k) {
      CHECK(std::fabs(near->p[k] - searched.p[k]) <= 1e-9 * (searched.p[k] + 1e-3));
      for (std::size_t j = 0; j < 3; ++j)
        CHECK(std::fabs(near->slope[k][j] - searched.slope[k][j]) <= 1e-9);
    }
  }
  CHECK(followed >= 40);
}

TEST_CASE("the steady state is the same with and without following waves (H3.2)",
          "[core][heat][identity]") {
  for (const double torque : {0.1, 0.5, 0.9}) {
    const MotorDesign design = with_table(warm_motor());
    HeatProblem searching = heat_problem(design, network_of(design), heat_load(torque));
    const HeatSolver following(searching);
    searching.losses = [losses = searching.losses](const NodeTemperatures& x) {
      WarmLosses found = losses(x);
      found.wave.reset();
      return found;
    };
    const SteadyState a = following.from_cold(), b = HeatSolver(searching).from_cold();
    REQUIRE(a.state.status == b.state.status);
    // the last step of Newton's method is at most 1e-5 K, and leaves its square times the bend
    for (std::size_t j = 0; j < 3; ++j) CHECK(std::fabs(a.state.x[j] - b.state.x[j]) <= 1e-8);
  }
}
