// SPDX-License-Identifier: Apache-2.0
// Parts of a calibration: residuals of one motor, and what several local fits say together.
#include "entries_support.hpp"
#include "kinds/calibrate/calibration.hpp"
#include "kinds/calibrate/measured_fit.hpp"
#include "kinds/sensitivity/unit_box.hpp"
#include "support/constants.hpp"

#include <twum/optim/random.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <numbers>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::StartsWith;
using P = Parameter;

namespace {

constexpr double kRpm = 2 * std::numbers::pi / 60;

MotorDesign elastic() {
  const ScratchFolder folder;
  return study_in(folder, "{kind: curve, points: 3}").motor.design;
}

// On its plateau, here at 1 and 2 rpm, the elastic layer has the torque mu F_N r.
constexpr double kRadius = 0.0265;
double plateau(double friction, double preload) { return friction * preload * kRadius; }

std::vector<MeasuredPoint> two_points(double first, double second) {
  return {torque_point(1 * kRpm, first), torque_point(2 * kRpm, second)};
}

// A fit of three points that ended at a value of the kinetic friction with a root mean square.
optim::LeastSquaresResult fit_at(double value, double rms, optim::Outcome outcome,
                                 bool undetermined = false) {
  optim::LeastSquaresResult fit;
  fit.outcome = outcome;
  fit.estimates = {{"kinetic_friction", value, 0.01, value - 0.02, value + 0.02, false}};
  fit.sum_of_squares = 2 * rms * rms;
  fit.correlation = {1};
  if (undetermined) fit.undetermined = {{"kinetic_friction"}};
  return fit;
}

const CalibrateResult& result_of(const KindAnswer& answer) {
  return std::get<CalibrateResult>(answer.answer);
}

}  // namespace

TEST_CASE("whole numbers take equal shares of the unit box", "[studies][sensitivity]") {
  const UnitBox box({{P::wavelengths, 8, 10},
                     {P::preload, 100, 200},
                     {P::thickness, 1e-4, 1e-2, optim::Scale::log}});
  CHECK(box.parameters() == std::vector<P>{P::wavelengths, P::preload, P::thickness});
  const auto waves = [&](double u) { return box.values(std::vector<double>{u, 0.5, 0.5})[0]; };
  // 8, 9 and 10 have a third each; the end belongs to 10.
  CHECK(waves(0) == 8);
  CHECK(waves(0.33) == 8);
  CHECK(waves(0.34) == 9);
  CHECK(waves(0.66) == 9);
  CHECK(waves(0.67) == 10);
  CHECK(waves(1) == 10);
  const std::vector<double> middle = box.values(std::vector<double>{0.5, 0.5, 0.5});
  CHECK(middle[1] == 150);
  CHECK(middle[2] == Approx(1e-3).epsilon(1e-14));  // the geometric mean; some roundings of pow
}

TEST_CASE("a whole number's coordinate is that of its value", "[studies][sensitivity]") {
  const UnitBox linear({{P::wavelengths, 8, 10}, {P::preload, 100, 200}});
  CHECK(linear.coordinates(std::vector<double>{0.4, 0.7}) == std::vector<double>{0.5, 0.7});
  CHECK(linear.coordinates(std::vector<double>{0.1, 0.0}) == std::vector<double>{0.0, 0.0});
  CHECK(linear.coordinates(std::vector<double>{0.9, 1.0}) == std::vector<double>{1.0, 1.0});
  // On a logarithmic scale from 2 to 8 the number 4 lies in the middle.
  const UnitBox logarithmic({{P::wavelengths, 2, 8, optim::Scale::log}});
  // The number 4 has the share from log(4/2) to log(5/2) of log(9/2): 0.461 to 0.609.
  CHECK(logarithmic.coordinates(std::vector<double>{0.55})[0] == Approx(0.5).epsilon(1e-14));
  CHECK(logarithmic.coordinates(std::vector<double>{0.45})[0] ==
        Approx(std::log(1.5) / std::log(4.0)).epsilon(1e-14));
}

TEST_CASE("the slope of a variable by its coordinate is its range, or that of its logarithm",
          "[studies][sensitivity]") {
  const UnitBox box({{P::wavelengths, 8, 10},
                     {P::preload, 100, 250},
                     {P::thickness, 1e-4, 1e-2, optim::Scale::log}});
  CHECK(std::isnan(box.slope(0, 9)));  // whole numbers have none
  CHECK(box.slope(1, 120) == 150);
  CHECK(box.slope(2, 3e-4) == Approx(3e-4 * std::log(100.0)).epsilon(1e-14));
}

TEST_CASE("residuals and their slopes are those of the plateau", "[studies][calibrate]") {
  const MeasuredFit fit(
      elastic(),
      {FitParameter{{P::kinetic_friction, 0.1, 0.4}}, FitParameter{{P::preload, 50, 200}}},
      {torque_point(1 * kRpm, 0.5, 4), torque_point(2 * kRpm, 0.6)});
  const std::vector<double> values{0.25, 100};
  const optim::Residuals r = fit.residuals(values);
  CHECK(r.failure.empty());
  const double torque = plateau(0.25, 100);
  // Solutions are good to about 1e-12; the root of a weight of 4 is 2.
  CHECK(r.values[0] == Approx(2 * (torque - 0.5)).epsilon(1e-9));
  CHECK(r.values[1] == Approx(torque - 0.6).epsilon(1e-9));
  CHECK(r.jacobian[0] == Approx(2 * plateau(1, 100)).epsilon(1e-9));
  CHECK(r.jacobian[1] == Approx(2 * plateau(0.25, 1)).epsilon(1e-9));
  CHECK(r.jacobian[3] == Approx(plateau(0.25, 1)).epsilon(1e-9));
  CHECK(fit.rms(std::vector<double>{3, 4}) == Approx(std::sqrt(12.5)));
  CHECK(fit.size() == Approx(std::sqrt((4 * 0.25 + 0.36) / 2)));
}

TEST_CASE("values that make no motor, and motors without a torque, are failures with a reason",
          "[studies][calibrate]") {
  const MeasuredFit fit(elastic(), {FitParameter{{P::static_friction, 0.05, 0.5}}},
                        two_points(0.8, 0.8));
  const optim::Residuals none = fit.residuals(std::vector<double>{0.1});  // below the kinetic 0.2
  CHECK_THAT(none.failure, StartsWith("not a motor: "));
  CHECK(none.values.empty());
  CHECK(fit.residuals(std::vector<double>{0.3}).failure.empty());
  // Faster backwards than the wave itself: there the model has no operating point.
  const MeasuredFit beyond(elastic(), {FitParameter{{P::preload, 50, 200}}},
                           {torque_point(-1e6, 0.8)});
  CHECK(beyond.residuals(std::vector<double>{100}).failure == "torque: out-of-range");
}

TEST_CASE("static friction that is estimated itself does not follow the kinetic one",
          "[studies][calibrate]") {
  MotorDesign motor = elastic();
  motor.friction.threshold = 0.3;  // 1.5 times the kinetic 0.2
  const std::vector<P> others{P::preload,   P::amplitude, P::youngs_modulus,
                              P::thickness, P::frequency, P::contact_width};
  // Whatever stands before and after it.
  for (std::size_t before = 0; before <= others.size(); ++before) {
    for (std::size_t after = 0; before + after <= others.size(); ++after) {
      const auto ratio = [&](const std::vector<P>& here) {
        std::vector<DesignVariable> ranges;
        for (std::size_t i = 0; i < before; ++i) ranges.push_back({others[i], 1, 2});
        for (const P p : here) ranges.push_back({p, 0.1, 0.5});
        for (std::size_t i = before; i < before + after; ++i) ranges.push_back({others[i], 1, 2});
        return MeasuredFit(motor, {ranges.begin(), ranges.end()}, two_points(0.8, 0.8))
            .static_ratio();
      };
      CHECK(ratio({P::kinetic_friction}) == Approx(1.5).epsilon(1e-15));
      CHECK(ratio({P::kinetic_friction, P::static_friction}) == 1);
      CHECK(ratio({P::static_friction}) == 1);
      CHECK(ratio({}) == 1);
    }
  }
  motor.friction = {0, 0.3};  // no ratio to keep
  CHECK(MeasuredFit(motor, {FitParameter{{P::kinetic_friction, 0.1, 0.5}}}, two_points(1, 1))
            .static_ratio() == 1);
}

TEST_CASE("a fit begins where the study says, else at the motor if that is in the range",
          "[studies][calibrate]") {
  const std::vector<DesignVariable> ranges{{P::kinetic_friction, 0.1, 0.5},  // the motor has 0.2
                                           {P::preload, 200, 300},           // 160 N
                                           {P::amplitude, 1e-7, 1e-6},       // 1.6 um
                                           {P::thickness, 1e-4, 1e-3, optim::Scale::log, 5e-4}};
  const MeasuredFit fit(elastic(), {ranges.begin(), ranges.end()}, two_points(0.8, 0.8));
  const auto own = fit.variables({});
  CHECK(own[0].start == 0.2);
  CHECK(std::isnan(own[1].start));  // below its range: the middle
  CHECK(std::isnan(own[2].start));  // above it
  CHECK(own[3].start == 5e-4);
  CHECK(own[3].scale == optim::Scale::log);
  const std::vector<double> start{0.3, 250, 5e-7, 2e-4};
  const auto given = fit.variables(start);
  for (std::size_t j = 0; j < 4; ++j) CHECK(given[j].start == start[j]);
}

TEST_CASE("the best fit is an optimum, unless one that stopped short is better",
          "[studies][calibrate]") {
  using optim::Outcome;
  const MeasuredFit fit(elastic(), {FitParameter{{P::kinetic_friction, 0.1, 0.5}}},
                        two_points(plateau(0.2, 160), plateau(0.2, 160)));
  const auto chosen = [&](const std::vector<optim::LeastSquaresResult>& fits) {
    return result_of(calibration({fit}, fits)).estimates[0].parameter.value;
  };
  const auto optimal = Outcome::optimal;
  const auto budget = Outcome::budget;
  CHECK(chosen({fit_at(0.2, 1e-3, optimal), fit_at(0.3, 1e-3, optimal)}) == 0.2);  // the first
  CHECK(chosen({fit_at(0.2, 2e-3, optimal), fit_at(0.3, 1e-3, optimal)}) == 0.3);  // the better
  CHECK(chosen({fit_at(0.2, 1e-3, budget), fit_at(0.3, 1e-3, optimal)}) == 0.3);   // the finished
  CHECK(chosen({fit_at(0.2, 1e-3, budget), fit_at(0.3, 1e-3, budget)}) == 0.2);
  CHECK(chosen({fit_at(0.2, 2e-3, optimal), fit_at(0.3, 1e-3, budget)}) == 0.3);
  CHECK(chosen({{}, fit_at(0.3, 1e-3, optimal)}) == 0.3);  // the first start could not be evaluated
  CHECK(calibration({fit}, {{}, {}}).outcome == "failed");
  CHECK(result_of(calibration({fit}, {{}, {}})).data.size() == 2);
}

TEST_CASE("starts that ended in one place are counted together", "[studies][calibrate]") {
  using optim::Outcome;
  const MeasuredFit fit(elastic(), {FitParameter{{P::kinetic_friction, 0.1, 0.5}}},
                        two_points(plateau(0.2, 160), plateau(0.2, 160)));
  const auto optima = [&](const std::vector<optim::LeastSquaresResult>& fits) {
    return result_of(calibration({fit}, fits)).optima;
  };
  const auto optimal = Outcome::optimal;
  // A thousandth of the range, 0.4, is near.
  const auto near = optima({fit_at(0.2, 1e-3, optimal), fit_at(0.2003, 1e-3, optimal)});
  REQUIRE(near.size() == 1);
  CHECK(near[0].starts == 2);
  const auto far = optima({fit_at(0.2, 1e-3, optimal), fit_at(0.201, 1e-3, optimal)});
  CHECK(far.size() == 2);
  const auto worse =
      optima({fit_at(0.2, 2e-3, optimal), fit_at(0.2, 1e-3, optimal), fit_at(0.3, 3e-3, optimal)});
  REQUIRE(worse.size() == 3);  // one place, but not as good
  CHECK(worse[0].residual_rms == Approx(1e-3));
  CHECK(worse[2].residual_rms == Approx(3e-3));
  // What the data do not determine tells no places apart.
  const auto loose = optima({fit_at(0.2, 1e-3, optimal, true), fit_at(0.4, 1e-3, optimal, true)});
  REQUIRE(loose.size() == 1);
  CHECK(loose[0].starts == 2);
  // One that stopped short is no place, unless it is the best.
  CHECK(optima({fit_at(0.2, 1e-3, optimal), fit_at(0.4, 2e-3, Outcome::budget)}).size() == 1);
  CHECK(optima({fit_at(0.2, 2e-3, optimal), fit_at(0.4, 1e-3, Outcome::budget)}).size() == 2);
}

TEST_CASE("what undoes a change of one factor of a product is the other factor",
          "[studies][calibrate]") {
  // On the plateau mu and F_N count as their product only: 1 % more of one undoes 1 % less of the other,
  // wherever they stand among the estimates.
  const std::vector<DesignVariable> rest{{P::modal_damping, 0, 1},
                                         {P::neutral_plane_distance, 2e-3, 4e-3},
                                         {P::amplitude, 1e-6, 2e-6},
                                         {P::contact_width, 3e-3, 5e-3},
                                         {P::frequency, 3e4, 5e4}};
  const MotorDesign motor = elastic();
  for (std::size_t before = 0; before <= rest.size(); ++before) {
    for (std::size_t between = 0; before + between <= rest.size(); ++between) {
      std::vector<DesignVariable> ranges(rest.begin(), rest.begin() + static_cast<int>(before));
      ranges.push_back({P::kinetic_friction, 0.1, 0.5});
      for (std::size_t i = before; i < before + between; ++i) ranges.push_back(rest[i]);
      ranges.push_back({P::preload, 100, 300});
      const MeasuredFit fit(motor, {ranges.begin(), ranges.end()}, two_points(0.8, 0.9));
      optim::LeastSquaresResult one;
      one.outcome = optim::Outcome::optimal;
      for (const DesignVariable& range : ranges)
        one.estimates.push_back(
            {std::string(info(range.parameter).name), get(motor, range.parameter), 0, 0, 0, false});
      one.undetermined = {{"kinetic_friction", "preload"}, {"amplitude", "x", "y"}};
      const CalibrateResult result = result_of(calibration({fit}, {one}));
      REQUIRE(result.undetermined.size() == 2);
      CHECK(result.undetermined[0].undone_by == Approx(-1).epsilon(1e-9));
      CHECK(std::isnan(result.undetermined[1].undone_by));  // of three there is no such number
    }
  }
}

TEST_CASE("a result is at its bounds if every estimate is", "[studies][calibrate]") {
  CalibrateResult result;
  CHECK_FALSE(result.at_bounds());
  for (std::size_t size = 1; size <= 8; ++size) {
    result.estimates.assign(size, {});
    for (std::size_t i = 0; i < size; ++i)
      result.estimates[i].bound =
          i % 2 == 0 ? CalibrateResult::Bound::min : CalibrateResult::Bound::max;
    CHECK(result.at_bounds());
    for (std::size_t i = 0; i < size; ++i) {
      const auto held = std::exchange(result.estimates[i].bound, CalibrateResult::Bound::none);
      CHECK_FALSE(result.at_bounds());
      result.estimates[i].bound = held;
    }
  }
}

TEST_CASE("the misfit is in parts of the largest torque", "[studies][calibrate]") {
  CalibrateResult result;
  CHECK(result.misfit() == 0);  // nothing was fitted
  result.residual_rms = 0.05;
  CHECK(result.misfit() == 0);  // without a torque there is no part of it
  result.data = {{0, 0.3, 1, kNaN, kNaN}, {1, -0.5, 1, kNaN, kNaN}};
  CHECK(result.misfit() == Approx(0.1));
}

TEST_CASE("points in any order of speed are tested in the order of speed", "[studies][calibrate]") {
  const MotorDesign motor = elastic();
  const double torque = plateau(0.2, 160);
  const auto correlation = [&](const std::vector<MeasuredPoint>& points) {
    const MeasuredFit fit(motor, {FitParameter{{P::kinetic_friction, 0.1, 0.5}}}, points);
    optim::LeastSquaresResult one = fit_at(0.2, 0.01, optim::Outcome::optimal);
    one.degrees_of_freedom = points.size() - 1;
    return result_of(calibration({fit}, {one})).neighbours->correlation;
  };
  // Shuffled in whatever way, equal residuals of one sign below a speed and the other above it have one pair of neighbours that
  // differ, of size - 1. The torques are rounded, to 1e-13 of the residuals.
  for (std::size_t size = 2; size <= 60; size += 2) {
    std::vector<std::size_t> order(size);
    std::iota(order.begin(), order.end(), std::size_t{0});
    optim::Random random(size, 0, 0);
    for (std::size_t i = size; i > 1; --i) std::swap(order[i - 1], order[random.below(i)]);
    std::vector<MeasuredPoint> points;
    for (const std::size_t place : order)
      points.push_back(torque_point((1 + 0.01 * static_cast<double>(place)) * kRpm,
                                    torque + (2 * place < size ? 0.01 : -0.01)));
    const double pairs = static_cast<double>(size) - 1;
    CHECK(correlation(points) == Approx((pairs - 2) / pairs).margin(1e-10));
  }
}

TEST_CASE("an estimate at a bound tells who follows it, if that is known and notable",
          "[studies][calibrate]") {
  const MeasuredFit fit(
      elastic(),
      {FitParameter{{P::kinetic_friction, 0.1, 0.2}}, FitParameter{{P::preload, 100, 300}}},
      two_points(plateau(0.2, 160), plateau(0.2, 160)));
  optim::LeastSquaresResult one;
  one.outcome = optim::Outcome::optimal;
  one.estimates = {{"kinetic_friction", 0.2, 0, 0.2, 0.2, true},
                   {"preload", 160, 1, 158, 162, false}};
  const auto followers = [&] {
    return result_of(calibration({fit}, {one})).estimates[0].followers;
  };
  CHECK(followers().empty());  // nobody said by how much
  // The preload falls by 800 N for a friction of 1 more: 1 % of 0.2 is 1.6 N, 1 % of 160 N.
  one.follows = {0, 0, -800, 0};
  REQUIRE(followers().size() == 1);
  CHECK(followers()[0].name == "preload");
  CHECK(followers()[0].percent == Approx(-1));
  one.follows = {0, 0, -0.7, 0};  // less than a thousandth of that
  CHECK(followers().empty());
  one.follows = {0, 0, -800, 0};
  one.estimates[1].at_bound = true;  // it moves no more than the first
  CHECK(followers().empty());
  CHECK(result_of(calibration({fit}, {one})).estimates[0].bound == CalibrateResult::Bound::max);
}
