// SPDX-License-Identifier: Apache-2.0
#include "motion/motion_motors.hpp"

#include "support/csv_rows.hpp"

#include <catch2/catch.hpp>

#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>

#include <map>

// Motions of the oscillating engine against another program that resolves every vibration, and against the core's steady waves.
namespace {

using namespace twum;
using namespace twum::motion;
using namespace twum::test;
using Event = MotionEventKind;

constexpr double kQuarterTurn = std::numbers::pi / 2, kDegree = std::numbers::pi / 180;

MotionTask oscillating(const MotorDesign& d, double duration) {
  MotionTask task = steady_drive(d, duration);
  task.engine = MotionEngine::oscillating;
  return task;
}

// The phase difference of a lead eps of the second phase beyond a quarter of a turn (D6.1).
Profile difference_of(const Profile& eps) {
  std::vector<Profile::Row> rows;
  for (const auto& [time, value] : eps.rows()) rows.emplace_back(time, kQuarterTurn - value);
  return Profile(rows);
}

TEST_CASE("oscillating motions follow another program within four times its error (M9.3, M9.4)",
          "[motion][oscillating][reference]") {
  std::map<std::string, std::vector<CsvRow>> motions;
  for (const CsvRow& row : csv_rows("motion/direct.csv"))
    if (row["Ls"] == 0) motions[row.word("name")].push_back(row);
  REQUIRE(motions.size() == 10);
  for (const auto& [name, rows] : motions) {
    CAPTURE(name);
    const CsvRow& first = rows.front();
    MotorDesign d = elastic_60(first["J"]);
    d.stator.blocked_capacitance = first["C0"];
    d.rotor.mass = first["mrot"], d.rotor.axial_damping = first["zd"];
    MotionTask task = oscillating(d, rows.back()["t"]);
    task.voltage = profile_of(first.word("V")), task.frequency = profile_of(first.word("f"));
    task.load_torque = profile_of(first.word("TL"));
    task.phase_difference = difference_of(profile_of(first.word("eps")));
    for (const CsvRow& row : rows) task.output_times.push_back(row["t"]);
    const Motion m = simulate(d, task);
    REQUIRE(m.status == "ok");
    REQUIRE(m.samples.size() == rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
      CAPTURE(rows[i].word("t"));
      CHECK(m.samples[i].amplitude == Approx(rows[i]["A"]).margin(4 * rows[i]["A_tol"]));
      CHECK(m.samples[i].backward_amplitude ==
            Approx(std::abs(rows[i]["B"])).margin(4 * rows[i]["A_tol"]));
      CHECK(m.samples[i].speed == Approx(rows[i]["Omega"]).margin(4 * rows[i]["Omega_tol"]));
      CHECK(m.samples[i].angle == Approx(rows[i]["theta"]).margin(4 * rows[i]["theta_tol"]));
    }
  }
}

TEST_CASE("an oscillating motion ends in the core's steady state, the closer the finer",
          "[motion][oscillating][identity]") {
  const double load = 0.3;
  for (const bool elastic : {true, false}) {
    MotorDesign d = elastic_60(1e-4);
    if (!elastic) d.layer.given_inertia.reset(), d.layer.given_shear_viscosity.reset();
    const Motor motor(d);
    const double speed = evaluate(motor, {Metric::speed_at, Argument::torque, load}).value;
    const OperatingPoint point = motor.operating_point(speed);
    double before = 0;
    for (const double accuracy : {1.0, 2.0}) {
      CAPTURE(elastic, accuracy);
      // From the steady state with a layer of four turns; what is left of the transient decays by 1800 / s.
      MotionTask task = oscillating(d, 0.008);
      task.initial.steady = true, task.load_torque = load, task.accuracy = accuracy;
      const Motion m = simulate(d, task);
      REQUIRE(m.status == "ok");
      // The error of the scheme is linear in the strain rate of the layer's own oscillation, which takes 16 steps at an accuracy of
      // 1; an elastic layer has no such oscillation, and an error of the square of a step, 2 pi / 100.
      const double allowed = (elastic ? 5e-4 : 0.01) / accuracy;
      const double error = std::abs(m.last.speed / speed - 1);
      CHECK(error < allowed);
      CHECK(m.last.amplitude == Approx(point.amplitude).epsilon(allowed));
      CHECK(m.last.torque == Approx(load).margin(1e-3 * largest_torque(d)));
      CHECK(m.last.electrical_power == Approx(point.electrical_power).epsilon(3 * allowed));
      if (accuracy == 2) CHECK(error < 0.6 * before);  // of first order at least
      before = error;
    }
  }
}

TEST_CASE("the electrical energy of an oscillating start is stored, damped, or given to the rotor",
          "[motion][oscillating][identity]") {
  MotorDesign d = elastic_60(1e-4);
  d.load = ShaftLoad{.damping = 5e-3};
  MotionTask task = oscillating(d, 0.006);
  task.output_times = times_to(0.006, 6000);
  task.load_torque = 0.1;
  const Motion m = simulate(d, task);
  REQUIRE(m.status == "ok");
  const double mass = *d.stator.modal_mass, damping = modal_damping(d),
               omega = 2 * std::numbers::pi * 40.8e3;
  double damped = 0, rubbed = 0, carried = 0;
  for (std::size_t k = 1; k < m.samples.size(); ++k) {
    const MotionSample &a = m.samples[k - 1], &b = m.samples[k];
    const double dt = b.time - a.time, speed = (a.speed + b.speed) / 2;
    const auto square = [](const MotionSample& s) {
      return s.amplitude * s.amplitude + s.backward_amplitude * s.backward_amplitude;
    };
    damped += damping * omega * omega * (square(a) + square(b)) / 2 * dt;
    rubbed += (a.friction_power + b.friction_power) / 2 * dt;
    carried += (0.1 * speed + 5e-3 * speed * speed) * dt;
  }
  // A wave of both modes has the energy m_s (omega A)^2; the preload's work on the layer comes back.
  const double wave = mass * std::pow(omega * m.last.amplitude, 2);
  const double rotor = 1e-4 * m.last.speed * m.last.speed / 2;
  // The wave of a start does not have the drive's frequency: its losses are those of (omega_b A)^2, some 2 % more or less over the
  // first millisecond, in which a fifth of them happens; friction is right to the engine's 0.3 %.
  CHECK(m.last.energy == Approx(wave + rotor + damped + rubbed + carried).epsilon(5e-3));
}

TEST_CASE("mirrored inputs mirror an oscillating motion", "[motion][oscillating][identity]") {
  MotorDesign d = elastic_60(1e-4);
  d.rotor.mass = 0.05, d.rotor.axial_damping = 500;
  MotionTask task = oscillating(d, 0.004);
  task.load_torque = 0.2;
  task.phase_difference = 70 * kDegree;
  MotionTask mirrored = task;
  mirrored.load_torque = -0.2;
  mirrored.reversed = {{0, 0.004}};
  const Motion one = simulate(d, task), other = simulate(d, mirrored);
  // Sums over the points run the other way round the wavelength: rounding, which grows with the backward wave at most.
  CHECK(other.last.speed == Approx(-one.last.speed).epsilon(1e-7));
  CHECK(other.last.angle == Approx(-one.last.angle).epsilon(1e-7));
  CHECK(other.last.amplitude == Approx(one.last.backward_amplitude).epsilon(1e-7));
  CHECK(other.last.backward_amplitude == Approx(one.last.amplitude).epsilon(1e-7));
}

TEST_CASE("the phase difference changes the speed as another program found",
          "[motion][oscillating][reference]") {
  struct Row {
    double mass, eps, speed;  // [kg, deg, rad/s]
  };
  // To the digits given; the standing wave of a light rotor is unstable, and either wave may win.
  for (const Row& row :
       {Row{0, -30, 14.82}, Row{0, -75, 9.37}, Row{0, -85, 7.26}, Row{0, -90, 5.9},
        Row{0, -120, -11.73}, Row{0.1, -30, 5.82}, Row{0.1, -60, 2.92}, Row{0.1, -75, 1.47},
        Row{0.1, -85, 0.49}, Row{0.1, -90, 0}, Row{0.1, -180, -16.04}}) {
    CAPTURE(row.mass, row.eps);
    MotorDesign d = elastic_60(1e-4);
    d.rotor.mass = row.mass, d.rotor.axial_damping = 1000;
    MotionTask task = oscillating(d, 0.03);
    task.phase_difference = (90 - row.eps) * kDegree;
    const Motion m = simulate(d, task);
    const double speed = row.eps == -90 ? std::abs(m.last.speed) : m.last.speed;
    // Both programs have errors of 0.2 % of the largest speed at these steps.
    CHECK(speed == Approx(row.speed).margin(0.035));
  }
}

TEST_CASE("phases that are swapped at once reverse the rotor in the time of another program",
          "[motion][oscillating][reference]") {
  struct Row {
    double mass, off, zero, most;  // [kg, ms, ms, ms]
  };
  for (const Row& row : {Row{0, 0, 2.49, 4.55}, Row{0, 2, 3.20, 5.18}, Row{0.1, 0, 2.93, 7.19}}) {
    CAPTURE(row.mass, row.off);
    MotorDesign d = elastic_60(1e-4);
    d.rotor.mass = row.mass, d.rotor.axial_damping = 1000;
    MotionTask task = oscillating(d, 0.03);
    const double begin = 0.005, swap = begin + 1e-3 * row.off;
    task.initial.steady = true;
    if (row.off > 0) task.switched_off = {{begin, swap}};
    task.reversed = {{swap, 0.03}};
    task.output_times = times_to(0.03, 6000);
    const Motion m = simulate(d, task);
    CHECK(count_of(m, Event::swapped) == 1);
    const auto time_below = [&](double speed) {
      for (const MotionSample& s : m.samples)
        if (s.time > begin && s.speed <= speed) return 1e3 * (s.time - begin);
      return -1.0;
    };
    CHECK(time_below(0) == Approx(row.zero).epsilon(0.03));  // the table's tolerances
    CHECK(time_below(0.9 * m.last.speed) == Approx(row.most).epsilon(0.03));
  }
}

TEST_CASE("a backward wave grows at the rate of the core's linear theory (D6.7)",
          "[motion][oscillating][identity]") {
  struct Row {
    double speed, mass, from, to;  // the times between which it grows
  };
  for (const Row& row : {Row{0.1, 0, 0.01, 0.03}, Row{3, 0.1, 0.002, 0.003},
                         Row{6, 0.1, 0.002, 0.003}, Row{9, 0.1, 0.002, 0.007}}) {
    CAPTURE(row.speed, row.mass);
    MotorDesign d = elastic_60(1e6);  // so heavy that its speed stays
    d.rotor.mass = row.mass, d.rotor.axial_damping = row.mass > 0 ? 1000 : 0;
    const Motor motor(d);
    const OperatingPoint point = motor.operating_point(row.speed);
    MotionTask task = oscillating(d, row.to + 0.001);
    task.initial = {.speed = row.speed, .amplitude = point.amplitude, .phase_lag = point.phase_lag};
    task.output_times = {row.from, row.to};
    const Motion m = simulate(d, task);
    REQUIRE(m.samples.size() == 2);
    const double rate =
        std::log(m.samples[1].backward_amplitude / m.samples[0].backward_amplitude) /
        (row.to - row.from);
    const double core = evaluate(motor, {Metric::squeal_rate_at, Argument::speed, row.speed}).value;
    // The linear theory averages over the beat of both waves; another program finds the same within 5 %.
    CHECK(rate == Approx(core).epsilon(0.05));
  }
}

TEST_CASE("an undamped rotor hops near no-load, and damping keeps it down (M9.2)",
          "[motion][oscillating]") {
  // It takes 2 m_r times the growth rate of 1270 / s: 254 N s/m.
  for (const double damping : {0.0, 300.0}) {
    CAPTURE(damping);
    MotorDesign d = elastic_60(1e-4);
    d.rotor.mass = 0.1, d.rotor.axial_damping = damping;
    MotionTask task = oscillating(d, 0.02);
    const Motion m = simulate(d, task);
    const double steady = evaluate(Motor(d), {Metric::no_load_speed}).value;
    if (damping > 0)
      CHECK(m.last.speed == Approx(steady).epsilon(1e-3));
    else
      CHECK(m.last.speed < 0.8 * steady);
  }
}

TEST_CASE("a small wave and a load hold the rotor, which the oscillating engine tells",
          "[motion][oscillating]") {
  const MotorDesign d = elastic_60(1e-4, 20);
  MotionTask task = oscillating(d, 0.004);
  task.load_torque = 0.1;
  const Motion rest = simulate(d, task);
  CHECK(rest.last.held);
  CHECK(rest.events.empty());
  CHECK(std::abs(rest.last.angle) <
        1e-5);  // the twist of the layer, 3.3 urad per N m, twice while it rings
  task = oscillating(elastic_60(1e-4), 0.03);
  task.initial.steady = true;
  task.switched_off = {{0, 0.03}};
  const Motion stop = simulate(elastic_60(1e-4), task);
  CHECK(stop.last.held);
  CHECK(time_of(stop, Event::held) == Approx(0.0092).epsilon(0.05));  // another program's 9.20 ms
}

TEST_CASE("resistors stop an oscillating motor as another program's circuit does (M3.2)",
          "[motion][oscillating][reference]") {
  struct Stop {
    double inertia, resistance, angle;  // [kg m^2, ohm, mrad]
  };
  for (const Stop& stop :
       {Stop{7e-6, 459, 7.07}, Stop{1e-4, 459, 21.77}, Stop{1e-4, 2000, 31.65}}) {
    CAPTURE(stop.inertia, stop.resistance);
    MotorDesign d = elastic_60(stop.inertia);
    d.driver = Driver{stop.resistance};
    MotionTask task = oscillating(d, 0.02);
    task.initial.steady = true;
    task.switched_off = {{0, 0.02}};
    const Motion m = simulate(d, task);
    // 0.2 % of the speed and of the wave at these steps, and the digits given. The capacitance of a phase keeps the drive's voltage
    // for R_off C_0, 17 us with 2 kohm; that turns the rotor by 0.2 mrad, about which the table says nothing.
    CHECK(1e3 * m.last.angle ==
          Approx(stop.angle).margin(5e-3 * stop.angle + (stop.resistance > 1000 ? 0.25 : 0.0)));
  }
}

TEST_CASE("what the oscillating engine does not compute is refused",
          "[motion][oscillating][input]") {
  using Catch::Contains;
  const MotorDesign motor = elastic_60(1e-4);
  const MotionTask task = oscillating(motor, 0.001);
  const auto refused = [&](auto change, const char* words) {
    MotorDesign d = motor;
    MotionTask t = task;
    change(d, t);
    CHECK_THROWS_WITH(simulate(d, t), Contains(words));
  };
  refused([](MotorDesign& d, MotionTask&) { d.stator.radial_slices = 4; }, "radial_slices");
  refused([](MotorDesign& d, MotionTask&) { d.rotor.taper = 1e-5; }, "rotor_taper");
  refused([](MotorDesign& d, MotionTask&) { d.friction.threshold = 0.3; }, "static_friction");
  refused([](MotorDesign& d, MotionTask&) { d.stator.voltage.reset(); }, "voltage");
  refused([](MotorDesign& d, MotionTask&) { d.rotor.inertia = 1e-12; }, "too stiff");
  refused([](MotorDesign&, MotionTask& t) { t.phase_difference = 1.0; }, "rotor_mass is missing");
  refused([](MotorDesign&, MotionTask& t) { t.reversed = {{0, 0.001}}; }, "rotor_mass is missing");
  refused([](MotorDesign&, MotionTask& t) { t.accuracy = 3; }, "accuracy");
  refused(
      [](MotorDesign& d, MotionTask& t) {
        d.rotor.mass = 0, t.phase_difference = 1.0, t.initial.steady = true;
      },
      "steady beginning");
  refused([](MotorDesign&,
             MotionTask& t) { t.engine = MotionEngine::averaged, t.phase_difference = 1.0; },
          "one wave");
}

TEST_CASE("an oscillating motion stops where it is told to", "[motion][oscillating][input]") {
  const MotorDesign motor = elastic_60(1e-4);
  MotionTask task = oscillating(motor, 0.03);
  task.output_times = times_to(0.03, 300);
  task.go_on = [](double time) { return time < 0.004; };
  const Motion m = simulate(motor, task);
  CHECK(m.status == "stopped");
  CHECK(m.end == Approx(0.004).margin(2 / 40.8e3));
  CHECK(m.samples.back().time <= m.end);
  CHECK(m.samples.back().time > 0.0038);
}

TEST_CASE("unequal phases drive a backward wave of the size of the first-order theory (D6.5)",
          "[motion][oscillating][identity]") {
  MotorDesign d = elastic_60(1e-4);
  d.rotor.mass = 0, d.stator.imbalance = Imbalance{1.02, 0.01, 0};
  MotionTask task = oscillating(d, 0.012);
  task.load_torque = 0.2;
  const Motion m = simulate(d, task);
  const Motor motor(d);
  const double core = evaluate(motor, {Metric::backward_ratio_at, Argument::torque, 0.2}).value;
  // First order in a ratio of a per cent, and one averaged beat.
  CHECK(m.last.backward_amplitude / m.last.amplitude == Approx(core).epsilon(0.05));
}

}  // namespace
