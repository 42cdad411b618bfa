// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "heat/warm_design.hpp"

#include <twum/core/metric_value.hpp>

#include <functional>
#include <optional>
#include <vector>

namespace twum::inline v0_1::core {

/// Parts whose temperatures parameters follow, in the order of ThermalNode.
inline constexpr std::array<std::size_t, 3> kNodeParts{0, 3, 4};

/// The wave of a motor under a voltage where it carries its load, from which that at other temperatures is found.
struct LoadWave {
  double amplitude{0};  ///< [m]
  double speed{0};      ///< of the rotor [rad/s]
};

/// Losses of a motor at temperatures of its nodes, and their derivatives by these.
struct WarmLosses {
  MetricStatus status{MetricStatus::ok};
  Sources<double> p{};                    ///< [W]
  std::array<Vector3, kSources> slope{};  ///< p_x [W/K]
  std::optional<LoadWave> wave{};         ///< where it can be followed
};
using LossesAt = std::function<WarmLosses(const NodeTemperatures& x)>;
/// The same from a wave that is known at other temperatures. Nothing where it cannot be followed there.
using LossesNear =
    std::function<std::optional<WarmLosses>(const NodeTemperatures& x, const LoadWave& near)>;

/// A network at an ambient temperature, with losses that follow the temperatures.
struct HeatProblem {
  HeatNetwork network;
  double ambient;
  LossesAt losses;
  LossesNear followed{};  ///< a quicker way; may be empty
};

/// A state of the masses with the losses there.
struct HeatState {
  MetricStatus status{MetricStatus::ok};
  NodeTemperatures x{};                   ///< T_s, T_c, T_l [K]
  Sources<double> p{};                    ///< [W]
  std::array<Vector3, kSources> slope{};  ///< p_x
  Vector3 theta{};                        ///< of the masses above ambient [K]
  double time{0};                         ///< since the motor was cold, of a state on its way [s]
  Matrix3 moved{kIdentity3};  ///< how theta moves with that at the beginning of followed()
  Sources<double> heat{};     ///< integral of p since then [J]
  std::optional<LoadWave> wave{};
};

/// A fixed point of (H3.2) with what says whether the motor stays there.
struct SteadyState {
  HeatState state{};
  double gain{0};        ///< the eigenvalue of Phi_x that is farthest from zero (H3.3) [1]
  double slowest{0};     ///< largest real part of the eigenvalues of C^-1 (-K + B p_theta) [1/s]
  double lost_after{0};  ///< time after which the warm-up lost the point [s]; else 0

  bool ok() const { return state.status == MetricStatus::ok; }
};

/// Steady states and the way to them.
class HeatSolver {
 public:
  explicit HeatSolver(HeatProblem problem);

  /// The steady state that the cold motor reaches (H4.3). Newton's method from the ambient temperature (H3.3) where the way there
  /// is smooth, else the warm-up in time.
  SteadyState from_cold() const;
  /// The steady state that Newton's method finds from temperatures.
  SteadyState near(const NodeTemperatures& start) const;

  /// x = T_a + M theta + D p with p at x: by one step of Newton's method from a guess, or several where that moves it far.
  /// @param near  a state from which the wave is followed; null: it is searched anew
  HeatState at_masses(const Vector3& theta, NodeTemperatures guess,
                      const HeatState* near = nullptr) const;
  /// The motor in time from a state on, which is the first of the answer, in steps of (H4.3) that differ by `tolerance` from their
  /// halves [K]; ends at the time, or with a status where the point is lost. A step takes at most half of the fastest time
  /// constant, or of the time since the beginning: modes that still move then have passed one extreme at most. The wave is followed
  /// from step to step; a new search at the end has to confirm it.
  std::vector<HeatState> followed(const HeatState& state, double duration, double tolerance) const;
  /// Whether a search finds the wave of a state, which was followed there; true where nothing is followed.
  bool is_confirmed(const HeatState& state) const;
  /// The same solver, which follows no waves.
  HeatSolver searching() const;
  /// The way of followed() without an end, and without the search that confirms it. No step depends on how far it will be followed.
  class Way {
   public:
    Way(const HeatSolver& solver, const HeatState& start, double tolerance);
    /// Steps on until a time, or to where the point is lost. All states are ok but the first may not be.
    void go_on(const HeatSolver& solver, double until);
    const std::vector<HeatState>& states() const { return states_; }

   private:
    std::vector<HeatState> states_;
    double tolerance_, next_;
    bool lost_{false};
  };
  /// The end alone, in steps as long as their error allows.
  HeatState advanced(const HeatState& state, double duration, double tolerance) const;
  HeatState cold() const { return at_masses({}, ambient_nodes()); }
  NodeTemperatures cold_nodes() const { return ambient_nodes(); }
  /// theta after a time as E theta + v, with the losses of the cold motor (H4.1).
  struct Linear {
    Matrix3 E;
    Vector3 v;
  };
  Linear with_cold_losses(double time) const;
  /// The temperatures of all parts [K].
  PartValues<double> parts(const HeatState& state) const;
  /// How fast these rise [K/s]; those of the nodes with the losses that follow.
  PartValues<double> part_rates(const HeatState& state) const;
  /// (I - D p_x)^-1 of the nodes: what a change of their temperatures becomes with the losses that follow.
  Matrix3 settling(const HeatState& state) const;
  /// d theta' / d theta = C^-1 (-K + B p_theta)
  Matrix3 jacobian(const HeatState& state) const;
  /// theta'
  Vector3 rate(const HeatState& state) const;
  const NetworkMatrices<double>& matrices() const { return matrices_; }
  const Vector3& capacities() const { return capacities_; }
  double fastest() const { return fastest_; }
  /// Phi(x) from the losses at x (H3.2).
  NodeTemperatures image(const Sources<double>& p) const;
  /// Phi_x = N p_x (H3.3).
  Matrix3 loop(const std::array<Vector3, kSources>& slope) const;
  /// dPhi / dp.
  const std::array<Sources<double>, kParts>& response() const { return response_; }

 private:
  struct Step {
    HeatState end;
    double error;
  };
  NodeTemperatures ambient_nodes() const { return {ambient_, ambient_, ambient_}; }
  NodeTemperatures nodes_at(const Vector3& theta, const HeatState& known) const;
  /// One step (I - Phi_x)^-1 (Phi(x) - x).
  Vector3 newton_step(const HeatState& at) const;
  HeatState with_losses(const NodeTemperatures& x) const;
  /// The same from the wave of a state that is known, where it can be followed.
  HeatState with_losses_after(const NodeTemperatures& x, const HeatState* known) const;
  /// Newton's method; its status says why it found nothing.
  /// @param known  a state from which waves are followed; null: each is searched anew
  HeatState newton(NodeTemperatures x, const HeatState* known) const;
  bool leads_there(const HeatState& cold, const SteadyState& found) const;
  SteadyState judged(HeatState state) const;
  SteadyState marched() const;
  /// @param longest  step at the beginning [s]; later ones may have half of the time since then
  std::vector<HeatState> marched_to(const HeatState& start, double duration, double tolerance,
                                    double longest) const;
  struct Flow {
    Vector3 theta;
    Matrix3 exp;  ///< of dt J
  };
  Flow flow(const HeatState& state, double time) const;
  Step step(const HeatState& state, double time) const;
  struct Advance {
    HeatState state;
    double time;  ///< of the step
    double next;  ///< that the next step may have
  };
  Advance one_step(const HeatState& state, double wanted, double tolerance) const;

  HeatProblem problem_;
  double ambient_;
  double fastest_;  // time constant of the network [s]
  NetworkMatrices<double> matrices_;
  Vector3 capacities_;
  std::array<Sources<double>, kParts> response_;  // of the steady parts by p
};

}  // namespace twum::inline v0_1::core
