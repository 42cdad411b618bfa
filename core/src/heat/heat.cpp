// SPDX-License-Identifier: Apache-2.0
#include <twum/core/heat.hpp>

#include "design/stator_heat.hpp"
#include "design/thermal_design.hpp"
#include "heat/heat_modes.hpp"

#include <twum/base/error.hpp>
#include <twum/base/scalar_search.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace twum::inline v0_1 {

using namespace core;

namespace {

constexpr double kNever = std::numeric_limits<double>::infinity();

HeatNetwork one_node_network(const OneNode& node, double losses) {
  HeatNetwork network;
  network.one_node = true;
  network.stator_ambient = losses / node.rise;  // (H1.10)
  network.stator_capacity = network.stator_ambient * node.time_constant;
  return network;
}

PartTemperatures parts_of_state(const HeatModes& modes, const Masses<double>& z,
                                const Sources<double>& p) {
  return core::parts_of(parts_at(modes.matrices(), modes.masses(z), p));
}

// z as the cycle begins: what it holds of itself is exp(-mu T), the rest comes from the phases (H5.1).
Masses<double> periodic_start(const HeatModes& modes, std::span<const HeatPhase> phases) {
  Masses<double> z{};
  double period = 0;
  for (const HeatPhase& phase : phases) {
    z = modes.after(z, sources_of(phase.losses), phase.time);
    period += phase.time;
  }
  for (std::size_t k = 0; k < kMasses; ++k) z[k] /= -std::expm1(-modes.rates()[k] * period);
  return z;
}

HeatLosses mean_losses(std::span<const HeatPhase> phases) {
  HeatLosses mean;
  double period = 0;
  for (const HeatPhase& phase : phases) {
    mean.friction += phase.losses.friction * phase.time;
    mean.layer += phase.losses.layer * phase.time;
    mean.stator += phase.losses.stator * phase.time;
    mean.dielectric += phase.losses.dielectric * phase.time;
    period += phase.time;
  }
  return {mean.friction / period, mean.layer / period, mean.stator / period,
          mean.dielectric / period};
}

}  // namespace

double at(const PartTemperatures& t, Part part) {
  switch (part) {
    case Part::stator: return t.stator;
    case Part::rotor: return t.rotor;
    case Part::housing: return t.housing;
    case Part::contact: return t.contact;
    case Part::lining: break;
  }
  return t.lining;
}

HeatNetwork heat_network(const MotorDesign& design, const HeatLosses& at_reference) {
  if (!design.thermal) throw InputError("the motor needs 'thermal' for its temperatures");
  const Thermal& thermal = *design.thermal;
  if (thermal.one_node) return one_node_network(*thermal.one_node, at_reference.sum());
  const ThermalConductances& g = thermal.conductances;
  const auto path = [](const std::optional<double>& given) { return given.value_or(0); };
  return {stator_heat_capacity(design),
          path(thermal.rotor.heat_capacity),
          path(thermal.housing.heat_capacity),
          stator_contact_conductance(design),
          lining_conductance(design),
          stator_housing_conductance(design),
          path(g.rotor_housing),
          path(g.housing_ambient),
          path(g.stator_ambient),
          path(g.rotor_ambient)};
}

PartTemperatures steady_rises(const HeatNetwork& network, const HeatLosses& losses) {
  return parts_of(steady_parts(matrices_of(network), sources_of(losses)));
}

std::vector<double> time_constants(const HeatNetwork& network) {
  const HeatModes modes(network);
  if (network.one_node) return {1 / modes.rates()[0]};
  const Masses<double>& mu = modes.rates();
  return {1 / mu[2], 1 / mu[1], 1 / mu[0]};
}

PartTemperatures rises_after(const HeatNetwork& network, const PartTemperatures& start,
                             const HeatLosses& losses, double time) {
  const HeatModes modes(network);
  const Masses<double> z =
      modes.amplitudes(network.one_node ? Masses<double>{start.stator, 0, 0}
                                        : Masses<double>{start.stator, start.rotor, start.housing});
  const Sources<double> p = sources_of(losses);
  return parts_of_state(modes, modes.after(z, p, time), p);
}

double time_to_rise(const HeatNetwork& network, const HeatLosses& losses, Part part, double rise) {
  if (rise <= 0) return 0;
  const HeatModes modes(network);
  const Decay decay = decay_of(modes, static_cast<std::size_t>(part), {}, sources_of(losses));
  if (!(decay.base > rise)) return kNever;
  const auto above = [&](double t) { return decay.at(t) - rise; };
  if (above(0) >= 0) return 0;  // the contact has no mass
  double end = 1 / modes.rates()[0];
  while (above(end) < 0) end *= 2;
  return closed_in("the time to a temperature", above, {0, end, above(0), above(end)}).nearest();
}

HeatCycle heat_cycle(const HeatNetwork& network, std::span<const HeatPhase> phases) {
  if (phases.empty()) throw InputError("a cycle needs at least one phase");
  for (const HeatPhase& phase : phases)
    if (!(phase.time > 0)) throw InputError("a phase of a cycle needs a time of more than 0 s");
  const HeatModes modes(network);
  Masses<double> z = periodic_start(modes, phases);
  HeatCycle cycle;
  cycle.start = parts_of_state(modes, z, sources_of(phases.front().losses));
  cycle.mean = steady_rises(network, mean_losses(phases));  // (H5.2)
  PartValues<double> low, high;
  low.fill(kNever), high.fill(-kNever);
  for (const HeatPhase& phase : phases) {
    const Sources<double> p = sources_of(phase.losses);
    for (std::size_t i = 0; i < kParts; ++i) {
      const auto [lowest, highest] = decay_of(modes, i, z, p).range(phase.time);
      low[i] = std::min(low[i], lowest), high[i] = std::max(high[i], highest);
    }
    z = modes.after(z, p, phase.time);
  }
  cycle.low = parts_of(low), cycle.peak = parts_of(high);
  return cycle;
}

double duty_limit(const HeatNetwork& network, const HeatLosses& on, const HeatLosses& off,
                  double period, std::span<const std::optional<double>, kParts> limits) {
  const auto excess = [&](const PartTemperatures& rises) {
    double worst = -kNever;
    for (std::size_t i = 0; i < kParts; ++i)
      if (limits[i]) worst = std::max(worst, at(rises, static_cast<Part>(i)) - *limits[i]);
    return worst;
  };
  const auto at_share = [&](double share) {
    const HeatPhase phases[] = {{on, share * period}, {off, (1 - share) * period}};
    return excess(heat_cycle(network, phases).peak);
  };
  const double always = excess(steady_rises(network, on)),
               never = excess(steady_rises(network, off));
  if (always <= 0) return 1;
  if (never > 0) return 0;
  constexpr double kLeast = 1e-9;  // the contact takes its temperature at once, however short
  if (at_share(kLeast) > 0) return 0;
  return closed_in("the share of a period", at_share,
                   {kLeast, 1 - kLeast, at_share(kLeast), always})
      .nearest();
}

const char* to_string(Part value) noexcept {
  switch (value) {
    case Part::stator: return "stator";
    case Part::rotor: return "rotor";
    case Part::housing: return "housing";
    case Part::contact: return "contact";
    case Part::lining: return "lining";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1
