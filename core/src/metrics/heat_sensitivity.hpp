// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "metrics/heat_course.hpp"

#include <optional>
#include <vector>

namespace twum::inline v0_1::core {

/// How a course of temperatures moves with the parameters of the design (H6.4). A phase that several answers need is passed once.
class CourseSensitivity {
 public:
  /// @param course  with its lap has to outlive this
  CourseSensitivity(const MotorDesign& design, const HeatCourse& course, const HeatCourse::Lap& lap,
                    bool fixed_static_friction);

  bool is_with_fixed_static_friction() const { return fixed_; }
  /// Derivatives of the parts' temperatures at a moment of a lap that begins at ambient.
  /// @throws SearchFailure where the losses have no derivatives; likewise below
  std::array<Gradient, kParts> from_cold(const HeatCourse::Moment& moment);
  /// Those of a lap that returns.
  std::array<Gradient, kParts> in_cycle(const HeatCourse::Moment& moment);
  /// Those of the mean temperatures of a lap that returns.
  std::array<Gradient, kParts> of_mean();
  /// Those of the nodes under the load of a phase while the masses are at their means.
  /// @param state  the state of the phase there
  /// @param mean   of_mean()
  std::array<Gradient, 3> nodes_at_mean(std::size_t phase, const HeatState& state,
                                        const std::array<Gradient, kParts>& mean);

 private:
  /// By every parameter, and by the three masses as the course begins.
  static constexpr std::size_t kColumns = kParameterCount + kMasses;
  using Column = std::array<double, kColumns>;
  /// Derivatives of a state of the masses, and of the heat since the course began.
  struct Moves {
    std::array<Column, kMasses> theta{};
    std::array<Column, kSources> heat{};
  };
  /// What the parameters do at a state of the masses that stays.
  struct Local {
    HeatState state;
    std::array<Column, kParts> parts{};     ///< temperatures at losses that stay
    std::array<Column, kSources> losses{};  ///< at temperatures of the nodes that stay
    Matrix3 settle, jacobian;
    std::array<Column, kMasses> rate{};  ///< of theta'
  };

  Local local(std::size_t phase, const HeatState& state);
  std::array<Column, kSources> losses(std::size_t phase, const HeatState& state);
  void add_network(std::size_t phase, const HeatState& state, Local& into) const;
  Vector3 nodes(const Local& at, std::size_t column, const Vector3& theta) const;
  Sources<double> losses(const Local& at, std::size_t column, const Vector3& theta) const;
  Moves step(const Moves& from, const Local& a, const Local& middle, const Local& b,
             double h) const;
  /// A moment of a phase on the way through it.
  struct Place {
    double done;  ///< time since the phase began [s]
    Local at;
    Moves moves;
  };
  double next_step(std::size_t phase, double done) const;
  void take_next_step(std::size_t phase);
  Place take_step(std::size_t phase, const Place& from, double h);
  Moves through(std::size_t phase, double duration);
  const Moves& to(std::size_t phases);
  Moves to(const HeatCourse::Moment& moment);
  Moves returning();
  std::array<Gradient, kParts> parts(const HeatCourse::Moment& moment, const Moves& moves);
  static void begin_with(const std::array<Gradient, kMasses>& start, Moves& moves);

  const MotorDesign& design_;
  const HeatCourse& course_;
  const HeatCourse::Lap& lap_;
  bool fixed_;
  std::vector<NetworkNumber> numbers_;
  NetworkMatrices<double> still_;
  std::vector<Moves> ends_;                // after so many phases
  std::vector<std::vector<Place>> walks_;  // through each phase, as far as it was asked
};

}  // namespace twum::inline v0_1::core
