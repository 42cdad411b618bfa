// SPDX-License-Identifier: Apache-2.0
// Calibrations to data of every kind that a bench gives.
#include "calibrate_support.hpp"
#include "files/statistics/coverage.hpp"

#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <complex>
#include <functional>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

namespace {

// Normal numbers by Box and Muller; 1 - u is never 0.
class Noise {
 public:
  explicit Noise(std::uint64_t seed) : random_(seed, 0, 0) {}
  double operator()() {
    const double radius = std::sqrt(-2 * std::log(1 - random_.uniform()));
    return radius * std::cos(2 * std::numbers::pi * random_.uniform());
  }

 private:
  optim::Random random_;
};

double metric(const MotorDesign& design, Metric which, Argument argument = Argument::none,
              double at = 0) {
  return evaluate(Motor(design), MetricRequest{which, argument, at}).value;
}

// A table of numbers with their standard deviations, of which noise is a multiple.
struct Bench {
  std::string motor;
  std::string variables;
  std::vector<ParameterValue> truth;
  std::function<std::string(const MotorDesign&, Noise&, double)> csv;  // of the true motor
  bool long_columns{false};  // enough for a scatter of each
};

// Torques at speeds under two preloads that the bench sets.
std::string preloads(const MotorDesign& design, Noise& noise, double size) {
  std::string csv = "speed [rpm],torque [N.m],torque_sd [N.m],preload [N]\n";
  for (const double preload : {120.0, 180.0}) {
    const Motor motor(with(design, Parameter::preload, preload));
    for (const int rpm : {20, 60, 90, 110, 120, 130}) {
      const double torque = motor.operating_point(rpm * kRpm).torque;
      csv += number(rpm) + "," + number(torque + size * 4e-3 * noise()) + ",4e-3," +
             number(preload) + "\n";
    }
  }
  return csv;
}

// What a load bench reads at a torque: speed, current and power.
std::string loads(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "torque [N.m],speed_at [rpm],speed_at_sd [rpm],phase_current_at [A],phase_current_at_sd [A],"
      "electrical_power_at [W],electrical_power_at_sd [W]\n";
  for (const double torque : {0.1, 0.3, 0.5, 0.7, 0.9}) {
    const auto at = [&](Metric which) { return metric(design, which, Argument::torque, torque); };
    csv += number(torque) + "," + number(at(Metric::speed_at) / kRpm + size * 0.5 * noise()) +
           ",0.5," + number(at(Metric::phase_current_at) + size * 1e-3 * noise()) + ",1e-3," +
           number(at(Metric::electrical_power_at) + size * 0.1 * noise()) + ",0.1\n";
  }
  return csv;
}

// Numbers of the whole motor, each read a few times.
std::string plain(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque [N.m],holding_torque_sd [N.m]\n";
  for (int i = 0; i < 4; ++i)
    csv += number(metric(design, Metric::no_load_speed) / kRpm + size * 0.5 * noise()) + ",0.5," +
           number(metric(design, Metric::holding_torque) + size * 5e-3 * noise()) + ",5e-3\n";
  return csv;
}

// Torques at speeds, and numbers of the whole motor; as few as columns with a scatter of their own may be.
std::string mixture(const MotorDesign& design, Noise& noise, double size) {
  std::string csv =
      "speed [rpm],torque,torque_sd,no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque,"
      "holding_torque_sd\n";
  const Motor motor(design);
  for (const int rpm : {20, 40, 60, 70, 80, 90, 95, 100, 105, 110, 115, 120, 130})
    csv += number(rpm) + "," +
           number(motor.operating_point(rpm * kRpm).torque + size * 4e-3 * noise()) + ",4e-3," +
           number(metric(design, Metric::no_load_speed) / kRpm + size * 0.5 * noise()) + ",0.5," +
           number(metric(design, Metric::holding_torque) + size * 5e-3 * noise()) + ",5e-3\n";
  return csv;
}

// The free stator before an impedance analyser. The admittance from textbook algebra of complex numbers: C_0 with its loss
// beside a branch of R, L and C in series.
std::string circle(const MotorDesign& design, int each_way, double step, Noise& noise,
                   double size) {
  const auto value = [&](Parameter p) { return get(design, p); };
  const double theta = value(Parameter::force_factor);
  const double turn = 2 * std::numbers::pi * value(Parameter::resonance_frequency);
  const double l = value(Parameter::modal_mass) / (theta * theta);
  const double c = 1 / (turn * turn * l);
  const double r = turn * l / value(Parameter::quality_factor);
  std::string csv =
      "frequency [Hz],conductance [S],conductance_sd [S],susceptance [S],susceptance_sd [S]\n";
  for (int i = -each_way; i <= each_way; ++i) {
    const double f = value(Parameter::resonance_frequency) + step * i;
    const double w = 2 * std::numbers::pi * f;
    const std::complex<double> branch(r, w * l - 1 / (w * c));
    const std::complex<double> leak = std::complex<double>(value(Parameter::loss_tangent), 1) * w *
                                      value(Parameter::blocked_capacitance);
    const auto y = 1.0 / branch + leak;
    csv += number(f) + "," + number(y.real() + size * 2e-5 * noise()) + ",2e-5," +
           number(y.imag() + size * 2e-5 * noise()) + ",2e-5\n";
  }
  return csv;
}

std::string long_circle(const MotorDesign& design, Noise& noise, double size) {
  return circle(design, 8, 40, noise, size);
}
std::string short_circle(const MotorDesign& design, Noise& noise, double size) {
  return circle(design, 7, 45, noise, size);
}

const Bench kPreloads{"ring-60", kThree, kTruth, preloads};
const Bench kMixture{"ring-60", kThree, kTruth, mixture, true};
const Bench kLoads{
    "drive-60",
    "force_factor: {min: 0.3 N/V, max: 0.9 N/V}, quality_factor: {min: 50, max: 400}, "
    "youngs_modulus: {min: 0.2 GPa, max: 4 GPa, scale: log}",
    {{Parameter::force_factor, 0.53},
     {Parameter::quality_factor, 140},
     {Parameter::youngs_modulus, 1e9}},
    loads};
const Bench kPlain{"ring-60",
                   "kinetic_friction: {min: 0.05, max: 0.5}, amplitude: {min: 1 um, max: 2.2 um}",
                   {{Parameter::kinetic_friction, 0.23}, {Parameter::amplitude, 1.52e-6}},
                   plain};
const Bench kCircle{
    "drive-60",
    "resonance_frequency: {min: 38 kHz, max: 40 kHz}, quality_factor: {min: 50, max: 400}, "
    "modal_mass: {min: 10 g, max: 60 g}, blocked_capacitance: {min: 1 nF, max: 20 nF}",
    {{Parameter::resonance_frequency, 39020},
     {Parameter::quality_factor, 160},
     {Parameter::modal_mass, 0.027},
     {Parameter::blocked_capacitance, 8e-9}},
    long_circle,
    true};
const Bench kShortCircle{kCircle.motor, kCircle.variables, kCircle.truth, short_circle, true};

struct Named {
  const char* name;
  const Bench& bench;
};
const Named kBenches[] = {
    {"preloads", kPreloads},        {"loads", kLoads},    {"plain", kPlain}, {"circle", kCircle},
    {"short circle", kShortCircle}, {"mixture", kMixture}};

struct BenchCase : Case {
  explicit BenchCase(const Bench& bench) {
    motor = bench.motor;
    variables = bench.variables;
  }
};

MotorDesign truth_of(const Bench& bench) { return with(BenchCase(bench).design(), bench.truth); }

// How often the intervals of repeated noisy measurements of one bench hold the truth.
void check_coverage(const Named& named, const char* scatter, int trials) {
  const Bench& bench = named.bench;
  const MotorDesign truth = truth_of(bench);
  BenchCase one(bench);
  one.more = std::string("starts: 1, scatter: ") + scatter;
  std::vector<test::Coverage> covered(bench.truth.size());
  for (int trial = 0; trial < trials; ++trial) {
    Noise noise(static_cast<std::uint64_t>(trial) + 1);
    const Run run(one.file(bench.csv(truth, noise, 1)));
    for (std::size_t j = 0; j < covered.size(); ++j) {
      const auto& estimate = run.result().estimates[j];
      covered[j].count({estimate.parameter.value, estimate.low, estimate.high},
                       bench.truth[j].second);
    }
  }
  for (std::size_t j = 0; j < covered.size(); ++j) {
    CAPTURE(named.name, scatter, bench.truth[j].first, covered[j].share());
    if (trials >= 1000)
      WARN(named.name << ", scatter " << scatter << ", " << info(bench.truth[j].first).name << ": "
                      << 100 * covered[j].share() << " %");
    CHECK(covered[j].hits >= covered[j].fewest(0.95));
    CHECK(covered[j].hits <= covered[j].most(0.95));
  }
}

// With the scatter estimated and as stated; and of each column by itself, which takes long columns.
void check_coverage(int trials) {
  for (const Named& named : kBenches) {
    DYNAMIC_SECTION(named.name) {
      check_coverage(named, "estimated", trials);
      check_coverage(named, "stated", trials);
      if (named.bench.long_columns) check_coverage(named, "by-column", trials);
    }
  }
}

}  // namespace

TEST_CASE("data of every kind without noise give the parameters back",
          "[studies][calibrate][inverse]") {
  for (const Named& named : kBenches) {
    CAPTURE(named.name);
    Noise noise(1);
    BenchCase one(named.bench);
    one.more = "starts: 4";
    const Run run(one.file(named.bench.csv(truth_of(named.bench), noise, 0)));
    CHECK(run.answer.outcome == "fitted");
    // The numbers are right to 1e-10 of theirs at worst, where a load is searched for; the parameters to that times the condition
    // of the columns, below 1e3.
    for (std::size_t j = 0; j < named.bench.truth.size(); ++j)
      CHECK(run.result().estimates[j].parameter.value ==
            Approx(named.bench.truth[j].second).epsilon(1e-7));
  }
}

TEST_CASE("intervals of data of every kind cover the truth as often as they say",
          "[studies][calibrate][statistics]") {
  check_coverage(40);
}

TEST_CASE("intervals of data of every kind cover the truth as often as they say - many times",
          "[studies][calibrate][statistics][.long]") {
  check_coverage(1000);
}

TEST_CASE("both solvers of a fit end at one place, for data of every kind",
          "[studies][calibrate][consistency]") {
  if (!optim::least_squares_solvers().back().available) return;  // a build without GSL
  // Least squares from the same start; the gradient test holds both to 1e-5 of a cosine, and their last steps do better.
  for (const Named& named : kBenches) {
    CAPTURE(named.name);
    Noise noise(11);
    BenchCase one(named.bench);
    const std::string csv = named.bench.csv(truth_of(named.bench), noise, 1);
    const Run own(one.file(csv));
    one.more = "starts: 1, solver: 'gsl:lm'";
    const Run gsl(one.file(csv));
    CHECK(own.answer.outcome == gsl.answer.outcome);
    for (std::size_t j = 0; j < named.bench.truth.size(); ++j) {
      const auto& a = own.result().estimates[j];
      const auto& b = gsl.result().estimates[j];
      CHECK(a.parameter.value == Approx(b.parameter.value).epsilon(1e-6));
      CHECK(a.deviation == Approx(b.deviation).epsilon(1e-5));
    }
  }
}

TEST_CASE("parts of the admittance have the derivatives of their differences (D4.4)",
          "[studies][calibrate][derivative]") {
  const MotorDesign design = with(BenchCase(kCircle).design(), Parameter::frequency, 38.95e3);
  for (const CircuitPart part : {CircuitPart::conductance, CircuitPart::susceptance,
                                 CircuitPart::impedance, CircuitPart::impedance_phase}) {
    const MetricDerivative found = differentiate(design, part, false);
    for (const Parameter p :
         {Parameter::frequency, Parameter::resonance_frequency, Parameter::modal_mass,
          Parameter::quality_factor, Parameter::force_factor, Parameter::blocked_capacitance,
          Parameter::loss_tangent}) {
      CAPTURE(info(part).name, info(p).name);
      const double x = get(design, p);
      const auto at = [&](double y) {
        return differentiate(with(design, p, y), part, false).value.value;
      };
      // Four points: the error is of the order of h^4 (1e-4 of the value, Q times that of the resonance's width: 1e-7)
      // and of rounding over h, 1e-12.
      const double h = 1e-5 * x;
      const double slope =
          (8 * (at(x + h) - at(x - h)) - (at(x + 2 * h) - at(x - 2 * h))) / (12 * h);
      CHECK(found.gradient[index_of(p)] ==
            Approx(slope).epsilon(1e-7).margin(1e-9 * std::fabs(found.value.value / x)));
    }
  }
}

TEST_CASE("at the resonance the impedance circle has its diameter 1 / R_m (D4.4)",
          "[studies][calibrate][closed-form]") {
  const auto zero = std::vector<ParameterValue>{{Parameter::loss_tangent, 0}};
  const MotorDesign base = with(BenchCase(kCircle).design(), zero);
  const double f_r = get(base, Parameter::resonance_frequency);
  const MotorDesign at = with(base, Parameter::frequency, f_r);
  const double theta = get(base, Parameter::force_factor);
  const double r = 2 * std::numbers::pi * f_r * get(base, Parameter::modal_mass) /
                   get(base, Parameter::quality_factor) / (theta * theta);
  // Rounding of the branch's reactance, 1e-16 of w L, which is Q = 153 times R.
  CHECK(differentiate(at, CircuitPart::conductance, false).value.value ==
        Approx(1 / r).epsilon(1e-12));
  const double susceptance = 2 * std::numbers::pi * f_r * get(base, Parameter::blocked_capacitance);
  CHECK(differentiate(at, CircuitPart::susceptance, false).value.value ==
        Approx(susceptance).epsilon(1e-10));
  CHECK(differentiate(at, CircuitPart::impedance, false).value.value ==
        Approx(1 / std::hypot(1 / r, susceptance)).epsilon(1e-12));
  CHECK(differentiate(at, CircuitPart::impedance_phase, false).value.value ==
        Approx(-std::atan(susceptance * r)).epsilon(1e-10));
  const Case ring;
  CHECK(differentiate(ring.design(), CircuitPart::impedance, false).value.status ==
        MetricStatus::undefined);
}

TEST_CASE("several tables are one", "[studies][calibrate][identity]") {
  const BenchCase one(kPreloads);
  Noise noise(3);
  const std::string csv = preloads(truth_of(kPreloads), noise, 1);
  const std::size_t header = csv.find('\n') + 1;
  std::size_t half = header;
  for (int line = 0; line < 6; ++line) half = csv.find('\n', half) + 1;
  const Run whole(one.file(csv));
  const BenchCase two(kPreloads);
  StudyFile file = two.file(csv.substr(0, half));
  std::ofstream(two.folder.path("other.csv")) << csv.substr(0, header) << csv.substr(half);
  std::get<CalibrateStudy>(file.asked).data = {"points.csv", "other.csv"};
  const Run parts(file);
  REQUIRE(parts.result().data.size() == whole.result().data.size());
  for (std::size_t j = 0; j < kTruth.size();
       ++j)  // sums of weights in another order: rounding, as the search ends
    CHECK(parts.result().estimates[j].parameter.value ==
          Approx(whole.result().estimates[j].parameter.value).epsilon(1e-7));
}

TEST_CASE("stated deviations make intervals where no point is left over", "[studies][calibrate]") {
  BenchCase one(kPlain);
  const std::string csv =
      "no_load_speed [rpm],no_load_speed_sd [rpm],holding_torque [N.m],holding_torque_sd "
      "[N.m]\n140,2,0.9,0.02\n";
  const Run estimated(one.file(csv));
  CHECK(estimated.answer.outcome == "undetermined");
  one.more = "starts: 1, scatter: stated";
  const Run stated(one.file(csv));
  CHECK(stated.answer.outcome == "fitted");
  CHECK_THAT(stated.json(), Contains("\"scatter\":\"stated\""));
}
