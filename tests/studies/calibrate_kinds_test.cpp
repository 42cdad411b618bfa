// SPDX-License-Identifier: Apache-2.0
// Calibrations to data of every kind that a bench gives.
#include "calibrate_benches.hpp"

#include <twum/base/error.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;

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

TEST_CASE("temperatures of one warm-up without noise give conductances and capacities back",
          "[studies][calibrate][inverse][heat]") {
  using enum Parameter;
  Case one;
  one.motor = "warm-60";
  one.more = "starts: 1, scatter: by-column";
  const std::vector<Parameter> sought{conductance_housing_ambient, conductance_stator_housing,
                                      stator_heat_capacity, housing_heat_capacity};
  one.variables.clear();
  for (const Parameter p : sought) {
    const std::string unit(info(p).unit);
    one.variables += std::string(one.variables.empty() ? "" : ", ") + std::string(info(p).name) +
                     ": {min: 0.05 " + unit + ", max: 500 " + unit + ", scale: log}";
  }
  const MotorDesign truth = one.design();
  std::string csv = "torque [N.m],time [s],stator_temperature_at [K],housing_temperature_at [K]\n";
  for (const double seconds : {30, 60, 120, 240, 480, 1080, 2700}) {
    csv += "0.5," + number(seconds);
    for (const Metric part : {Metric::stator_temperature_at, Metric::housing_temperature_at}) {
      MetricRequest request{part, Argument::torque, 0.5};
      request.after = seconds;
      csv += "," + number(evaluate(Motor(truth), std::vector{request})[0].value);
    }
    csv += "\n";
  }
  // The motor of the study begins elsewhere.
  one.set =
      "{conductance_housing_ambient: 0.4 W/K, conductance_stator_housing: 1.5 W/K, "
      "stator_heat_capacity: 40 J/K, housing_heat_capacity: 80 J/K}";
  const Run run(one.file(csv));
  CHECK(run.answer.outcome == "fitted");
  // Of readings of some 300 K.
  for (const CalibrateResult::ColumnScatter& column : run.result().columns)
    CHECK(column.deviation <= 1e-4);
  // A course is followed to 1e-7 of its rises at least, times the condition of the columns, below 1e3.
  REQUIRE(run.result().estimates.size() == sought.size());
  for (std::size_t j = 0; j < sought.size(); ++j)
    CHECK(run.result().estimates[j].parameter.value == Approx(get(truth, sought[j])).epsilon(1e-4));
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
