// SPDX-License-Identifier: Apache-2.0
// The thermal network under constant losses. The reference tables are those of a second program, which solved the network with the
// contact as a node of its own and integrated the cycles in time.
#include <catch2/catch.hpp>

#include <twum/base/error.hpp>
#include <twum/core/heat.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>

#include "support/csv_rows.hpp"
#include "support/driven_motors.hpp"
#include "support/heat_motors.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_odeiv2.h>

#include <cmath>
#include <numbers>
#include <numeric>

using namespace twum;
using namespace twum::test;

namespace {

const HeatLosses kUsual{3.154, 0.755, 7.567, 0.628};

HeatNetwork network_of(const CsvRow& row) {
  const std::vector<double> c = row.list("C");
  return {c[0],       c[1],       c[2],       row["Gsc"], row["Gl"],
          row["Gsh"], row["Grh"], row["Gha"], row["Gsa"], row["Gra"]};
}

HeatLosses losses_of(const std::vector<double>& p) { return {p[0], p[1], p[2], p[3]}; }

void check_masses(const CsvRow& row, const std::string& what, const PartTemperatures& t,
                  double tolerance) {
  CHECK(std::fabs(t.stator - row[what + "_s"]) <= tolerance);
  CHECK(std::fabs(t.rotor - row[what + "_r"]) <= tolerance);
  CHECK(std::fabs(t.housing - row[what + "_h"]) <= tolerance);
}

// theta' of the masses from the heat that flows on each path; no matrix of the network.
struct Flows {
  HeatNetwork n;
  HeatLosses p;

  double contact(const double* t) const {
    return (p.friction + p.layer / 2 + n.stator_contact * t[0] + n.lining * t[1]) /
           (n.stator_contact + n.lining);
  }
};

int rates(double /*time*/, const double* t, double* rate, void* flows) {
  const Flows& f = *static_cast<const Flows*>(flows);
  const HeatNetwork& n = f.n;
  const double into_stator = n.stator_contact * (f.contact(t) - t[0]);
  const double into_rotor = n.lining * (f.contact(t) - t[1]) + f.p.layer / 2;
  const double stator_housing = n.stator_housing * (t[0] - t[2]),
               rotor_housing = n.rotor_housing * (t[1] - t[2]);
  rate[0] = (into_stator + f.p.stator + f.p.dielectric - stator_housing - n.stator_ambient * t[0]) /
            n.stator_capacity;
  rate[1] = (into_rotor - rotor_housing - n.rotor_ambient * t[1]) / n.rotor_capacity;
  rate[2] = (stator_housing + rotor_housing - n.housing_ambient * t[2]) / n.housing_capacity;
  return GSL_SUCCESS;
}

// By GSL's Runge-Kutta pair of orders 8 and 9.
void integrate(const Flows& flows, double* t, double time) {
  gsl_odeiv2_system system{rates, nullptr, 3, const_cast<Flows*>(&flows)};
  gsl_odeiv2_driver* driver =
      gsl_odeiv2_driver_alloc_y_new(&system, gsl_odeiv2_step_rk8pd, 1, 1e-12, 1e-12);
  double now = 0;
  REQUIRE(gsl_odeiv2_driver_apply(driver, &now, time, t) == GSL_SUCCESS);
  gsl_odeiv2_driver_free(driver);
}

}  // namespace

TEST_CASE("steady temperatures and time constants are a second program's (H1.2, H1.3, H1.4, H1.5)",
          "[core][heat][differential]") {
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/network_steady.csv")) {
    CAPTURE(++rows);
    const HeatNetwork network = network_of(row);
    const HeatLosses losses{row["P_fric"], row["P_layer"], row["P_stator"], row["P_diel"]};
    const PartTemperatures t = steady_rises(network, losses);
    // Both solve three equations; 1e-9 leaves a thousand times the condition number of the network, 1e3, in rounding errors.
    check_masses(row, "rise", t, 1e-9 * row["rise_s"]);
    CHECK(std::fabs(t.contact - row["rise_c"]) <= 1e-9 * row["rise_c"]);
    CHECK(std::fabs(t.lining - row["rise_l"]) <= 1e-9 * row["rise_l"]);
    const std::vector<double> tau = time_constants(network);
    for (std::size_t i = 0; i < 3; ++i)
      CHECK(std::fabs(tau[i] - row["tau" + std::to_string(i + 1)]) <= 1e-9 * tau[i]);
  }
  CHECK(rows == 9);
}

TEST_CASE(
    "duty cycles are a second program's, and their means those of the mean losses (H5.1, H5.2)",
    "[core][heat][differential]") {
  std::map<std::string, HeatNetwork> networks;
  for (const CsvRow& row : csv_rows("heat/network_steady.csv"))
    networks.insert({row.word("net"), network_of(row)});
  int rows = 0;
  for (const CsvRow& row : csv_rows("heat/network_duty.csv")) {
    CAPTURE(++rows);
    const HeatPhase phases[] = {{losses_of(row.list("P_on")), row["t_on"]},
                                {losses_of(row.list("P_off")), row["t_off"]}};
    const HeatCycle cycle = heat_cycle(networks.at(row.word("net")), phases);
    // what the second program's integration leaves after its cycles have settled
    check_masses(row, "start", cycle.start, 1e-8);
    check_masses(row, "peak", cycle.peak, 1e-8);
    check_masses(row, "low", cycle.low, 1e-8);
    check_masses(row, "mean", cycle.mean, 1e-8);
  }
  CHECK(rows == 4);
}

TEST_CASE("the heat to the ambient is the sum of the losses (H1.4)", "[core][heat][identity]") {
  const HeatNetwork n = usual_network();
  const PartTemperatures t = steady_rises(n, kUsual);
  const double away =
      n.stator_ambient * t.stator + n.rotor_ambient * t.rotor + n.housing_ambient * t.housing;
  CHECK(std::fabs(away - kUsual.sum()) <= 1e-13 * kUsual.sum());  // rounding times the condition
}

TEST_CASE("heat that arises evenly in a slab leaves it half at each face (H1.1, H1.3)",
          "[core][heat][closed-form]") {
  // T(z) = a + b z - P z^2 / (2 G), z from the contact to the rotor in thicknesses, solves G T'' = -P; b and a from the contact's
  // balance, in which the stator's temperature and the rotor's are those of the network. Simpson's rule is exact for a parabola.
  const HeatNetwork n = usual_network();
  const PartTemperatures t = steady_rises(n, kUsual);
  const double P = kUsual.layer, G = n.lining, a = t.contact;
  const double b = t.rotor - a + P / (2 * G);
  const auto T = [&](double z) { return a + b * z - P * z * z / (2 * G); };
  CHECK(std::fabs((T(0) + 4 * T(0.5) + T(1)) / 6 - t.lining) <= 1e-13 * t.lining);
  const double from_lining = G * b;  // heat that flows from it into the contact
  CHECK(std::fabs(n.stator_contact * (t.contact - t.stator) - kUsual.friction - from_lining) <=
        1e-12 * kUsual.friction);
}

TEST_CASE("the warm-up is that of an integration in time (H4.1)", "[core][heat][differential]") {
  const HeatNetwork n = usual_network();
  for (const double time : {3.0, 60.0, 900.0}) {
    CAPTURE(time);
    double t[] = {5, 20, 1};
    const PartTemperatures after = rises_after(n, {5, 20, 1, 0, 0}, kUsual, time);
    integrate({n, kUsual}, t, time);
    // 1e-12 a step, some hundred steps
    CHECK(std::fabs(after.stator - t[0]) <= 1e-9);
    CHECK(std::fabs(after.rotor - t[1]) <= 1e-9);
    CHECK(std::fabs(after.housing - t[2]) <= 1e-9);
  }
}

TEST_CASE("a cycle of an integration in time returns to its start (H5.1)",
          "[core][heat][differential]") {
  const HeatNetwork n = usual_network();
  const HeatPhase phases[] = {{kUsual, 90}, {{0, 0, 2, 0.6}, 40}, {{}, 300}};
  const HeatCycle cycle = heat_cycle(n, phases);
  double t[] = {cycle.start.stator, cycle.start.rotor, cycle.start.housing};
  for (const HeatPhase& phase : phases) integrate({n, phase.losses}, t, phase.time);
  CHECK(std::fabs(t[0] - cycle.start.stator) <= 1e-9);
  CHECK(std::fabs(t[1] - cycle.start.rotor) <= 1e-9);
  CHECK(std::fabs(t[2] - cycle.start.housing) <= 1e-9);
}

TEST_CASE("extrema of a cycle hold for 4,000 samples of it (H5.1)", "[core][heat][property]") {
  const HeatNetwork n = usual_network();
  const HeatPhase phases[] = {{kUsual, 200}, {{}, 300}};
  const HeatCycle cycle = heat_cycle(n, phases);
  PartTemperatures state = cycle.start, top{}, bottom{1e9, 1e9, 1e9, 1e9, 1e9};
  for (const HeatPhase& phase : phases) {
    for (int i = 0; i <= 2000; ++i) {
      const PartTemperatures t = rises_after(n, state, phase.losses, phase.time * i / 2000);
      top = {std::max(top.stator, t.stator), std::max(top.rotor, t.rotor),
             std::max(top.housing, t.housing), std::max(top.contact, t.contact), 0};
      bottom = {std::min(bottom.stator, t.stator), std::min(bottom.rotor, t.rotor),
                std::min(bottom.housing, t.housing), std::min(bottom.contact, t.contact), 0};
    }
    state = rises_after(n, state, phase.losses, phase.time);
  }
  // A smooth extremum lies between two samples 0.1 s apart: it is off by theta'' t^2 / 8 < 1e-4 K.
  CHECK(std::fabs(cycle.peak.housing - top.housing) <= 1e-4);
  CHECK(std::fabs(cycle.peak.rotor - top.rotor) <= 1e-4);
  CHECK(std::fabs(cycle.peak.stator - top.stator) <= 1e-9);
  CHECK(std::fabs(cycle.peak.contact - top.contact) <= 1e-9);
  CHECK(std::fabs(cycle.low.housing - bottom.housing) <= 1e-4);
  CHECK(cycle.peak.housing > rises_after(n, cycle.start, kUsual, 200).housing + 0.1);
}

TEST_CASE("one node warms by the closed forms (H1.10, H4.2)", "[core][heat][closed-form]") {
  MotorDesign design = driven_motor();
  design.thermal.emplace().one_node = OneNode{40, 0.5, 660};
  const HeatNetwork n = heat_network(design, {3, 1, 5, 1});
  const double G = 10 / 40.0;
  CHECK(std::fabs(time_constants(n).at(0) - 660) <= 1e-10);
  const HeatLosses losses{6, 2, 10, 2};  // twice those of the data sheet: twice the rise
  const PartTemperatures t = steady_rises(n, losses);
  for (const double rise : {t.stator, t.rotor, t.housing, t.contact, t.lining})
    CHECK(std::fabs(rise - 80) <= 1e-12);
  CHECK(std::fabs(time_to_rise(n, losses, Part::stator, 50) - 660 * std::log(80 / 30.0)) <= 1e-9);
  CHECK(std::isinf(time_to_rise(n, losses, Part::rotor, 80)));
  const HeatPhase phases[] = {{losses, 100}, {{}, 250}};
  const double peak = 20 / G * std::expm1(-100 / 660.0) / std::expm1(-350 / 660.0);
  CHECK(std::fabs(heat_cycle(n, phases).peak.stator - peak) <= 1e-11);
}

TEST_CASE("conductances without end between the masses make one node (H1.4)",
          "[core][heat][limit]") {
  HeatNetwork n = usual_network();
  n.stator_contact = n.lining = n.stator_housing = n.rotor_housing = 1e9;
  const double G = n.housing_ambient + n.stator_ambient + n.rotor_ambient,
               C = n.stator_capacity + n.rotor_capacity + n.housing_capacity;
  const PartTemperatures t = steady_rises(n, kUsual);
  // Differences are losses over conductances, 1e-8 K; rounding errors of the sums in K, 1e9 eps, are 1e-6 of G.
  for (const double rise : {t.stator, t.rotor, t.housing, t.contact, t.lining})
    CHECK(std::fabs(rise - kUsual.sum() / G) <= 1e-5 * kUsual.sum() / G);
  CHECK(std::fabs(time_constants(n).back() - C / G) <= 1e-5 * C / G);
}

TEST_CASE("more heat anywhere cools nothing, and what is never reached takes for ever (H4.2)",
          "[core][heat][property]") {
  const HeatNetwork n = usual_network();
  const PartTemperatures base = steady_rises(n, kUsual);
  for (const HeatLosses& more :
       {HeatLosses{1, 0, 0, 0}, HeatLosses{0, 1, 0, 0}, HeatLosses{0, 0, 1, 0}}) {
    const PartTemperatures t =
        steady_rises(n, {kUsual.friction + more.friction, kUsual.layer + more.layer,
                         kUsual.stator + more.stator, kUsual.dielectric});
    for (std::size_t i = 0; i < kParts; ++i)
      CHECK(at(t, static_cast<Part>(i)) > at(base, static_cast<Part>(i)));
  }
  // At the time found an integration has the rise.
  const double time = time_to_rise(n, kUsual, Part::stator, 40);
  double t[] = {0, 0, 0};
  integrate({n, kUsual}, t, time);
  CHECK(std::fabs(t[0] - 40) <= 1e-9);
  CHECK(std::isinf(time_to_rise(n, kUsual, Part::stator, base.stator + 0.1)));
  CHECK(time_to_rise(n, kUsual, Part::stator, 0) == 0);
}

TEST_CASE("at the duty limit the hottest part just keeps its limit (H5.1)",
          "[core][heat][property]") {
  const HeatNetwork n = usual_network();
  std::array<std::optional<double>, kParts> limits;
  limits[0] = 40;
  double last = 1;
  for (const double period : {10.0, 120.0, 600.0}) {
    CAPTURE(period);
    const double share = duty_limit(n, kUsual, {}, period, limits);
    const HeatPhase phases[] = {{kUsual, share * period}, {{}, (1 - share) * period}};
    CHECK(std::fabs(heat_cycle(n, phases).peak.stator - 40) <= 1e-9);
    CHECK(share < last);  // a longer period has higher peaks
    last = share;
  }
  limits[0] = 60;
  CHECK(duty_limit(n, kUsual, {}, 60, limits) == 1);
  limits[1] = -1;
  CHECK(duty_limit(n, kUsual, {}, 60, limits) == 0);
}

TEST_CASE("the lining conducts by its material and its size (H1.6)", "[core][heat][closed-form]") {
  MotorDesign design = with_heat(driven_motor());
  design.thermal->conductances.lining.reset();
  design.layer.conductivity = 0.25;
  design.layer.thickness = 0.5e-3;
  const double G = 0.25 * (2 * std::numbers::pi * 26.5e-3 * 4e-3) / 0.5e-3;  // of a slab
  CHECK(std::fabs(heat_network(design).lining - G) <= 1e-14);
  CHECK(std::fabs(get(design, Parameter::conductance_lining) - G) <= 1e-14);
  const auto slopes = parameter_jacobian(design)[index_of(Parameter::conductance_lining)];
  CHECK(std::fabs(slopes[index_of(Parameter::conductivity)] - G / 0.25) <= 1e-12);
  CHECK(std::fabs(slopes[index_of(Parameter::thickness)] + G / 0.5e-3) <= 1e-9);
  CHECK(std::fabs(slopes[index_of(Parameter::contact_radius)] - G / 26.5e-3) <= 1e-11);
  CHECK(std::fabs(slopes[index_of(Parameter::contact_width)] - G / 4e-3) <= 1e-11);
}

TEST_CASE("thermal blocks that mean nothing are refused, each with its reason",
          "[core][heat][errors]") {
  const auto wrong = [](auto change) {
    MotorDesign design = with_heat(driven_motor());
    change(design);
    const auto found = complaints(design);
    return found.empty() ? std::string() : found.front();
  };
  const auto has = [](const std::string& text, const std::string& part) {
    CAPTURE(text);
    return text.find(part) != std::string::npos;
  };
  CHECK(wrong([](MotorDesign&) {}).empty());
  CHECK(has(wrong([](MotorDesign& d) { d.thermal->rotor.heat_capacity.reset(); }),
            "rotor_heat_capacity must be given with thermal"));
  CHECK(has(wrong([](MotorDesign& d) {
              d.thermal->conductances.housing_ambient.reset();
              d.thermal->conductances.stator_ambient = d.thermal->conductances.rotor_ambient = 0;
            }),
            "the heat has no way out"));
  CHECK(has(wrong([](MotorDesign& d) {
              d.thermal->conductances.stator_housing = d.thermal->conductances.rotor_housing = 0;
              d.thermal->conductances.stator_ambient = d.thermal->conductances.rotor_ambient = 0;
            }),
            "the heat has no way out"));
  CHECK(has(wrong([](MotorDesign& d) { d.thermal->stator.temperature_limit = 290; }),
            "stator_temperature_limit must be at least ambient_temperature"));
  CHECK(has(wrong([](MotorDesign& d) {
              d.thermal->one_node = OneNode{40, 0.5, 660};
            }),
            "must be left out with one_node"));
  CHECK(has(wrong([](MotorDesign& d) { d.thermal->drift.quality_factor = -3e-3; }),
            "drift_quality_factor must be left out, but the motor is not given by quality_factor; "
            "give drift_modal_damping"));
  CHECK(has(wrong([](MotorDesign& d) { d.thermal->ambient = 0; }), "ambient_temperature"));
  CHECK_THROWS_AS(heat_network(driven_motor()), InputError);
  const std::vector<HeatPhase> none;
  CHECK_THROWS_AS(heat_cycle(usual_network(), none), InputError);
  CHECK_THROWS_AS(heat_cycle(usual_network(), std::vector<HeatPhase>{{kUsual, 0}}), InputError);
}

TEST_CASE("a network follows from the stator's geometry and materials (H1.7, H1.8, H1.9)",
          "[core][heat]") {
  MotorDesign design = warm_plate_motor();
  const stator::StatorGeometry& g = *design.stator.geometry;
  // Written out with the numbers of distinct_stator(); rounding only.
  const HeatNetwork network = heat_network(design);
  CHECK(network.stator_housing ==
        Approx(2 * std::numbers::pi * 77 * 1.4e-3 / std::log(0.0210 / 0.0125)).epsilon(1e-13));
  const double gap = 90 * 0.6e-3;
  CHECK(network.stator_contact ==
        Approx(77 * (2 * std::numbers::pi * design.stator.contact_radius - gap) *
               design.stator.contact_width / 1.5e-3)
            .epsilon(1e-13));
  // With one specific heat, that of the glue, the capacity is that times the mass, which the plate has by its laminate.
  design.stator.geometry->substrate.specific_heat = design.stator.geometry->ceramic.specific_heat =
      1100;
  CHECK(heat_network(design).stator_capacity ==
        Approx(1100 * evaluate(Motor(design), {Metric::stator_mass}).value).epsilon(1e-12));
  // What is given counts.
  design.thermal->conductances.stator_housing = 0.7;
  CHECK(heat_network(design).stator_housing == 0.7);
  CHECK(heat_network(design).stator_contact == network.stator_contact);
  CHECK(complaints(design).empty());
  REQUIRE(g.web);
}

TEST_CASE("what does not follow from the stator has to be given", "[core][heat][edge_case]") {
  const auto refused = [](const MotorDesign& design, const std::string& name) {
    const auto said = complaints(design);
    return !said.empty() && said.front().starts_with(name);
  };
  MotorDesign free = warm_plate_motor();
  free.stator.geometry->support = stator::InnerEdge::free;
  CHECK(refused(free, "conductance_stator_housing"));
  MotorDesign flat = warm_plate_motor();
  flat.stator.geometry->teeth.reset();
  CHECK(refused(flat, "conductance_stator_contact"));
  MotorDesign unknown = warm_plate_motor();
  unknown.stator.geometry->ceramic.specific_heat.reset();
  CHECK(refused(unknown, "stator_heat_capacity"));
  MotorDesign bare = warm_plate_motor();
  bare.stator.geometry->substrate.conductivity.reset();
  CHECK(refused(bare, "conductance_stator_contact"));
}
