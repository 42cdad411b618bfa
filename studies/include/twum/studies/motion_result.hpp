// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/column.hpp>
#include <twum/motion/control.hpp>
#include <twum/motion/motion.hpp>
#include <twum/studies/study.hpp>

#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Motions of one motor, or of a family over one parameter. The rows of the store are the samples: stage is the motor, index the
/// time.
struct MotionResult {
  /// A number of a motion that was asked for.
  struct Measure {
    std::string text;                    ///< as typed, such as "overshoot(speed)"
    std::string unit;                    ///< SI
    double value{0};                     ///< NaN where the motion does not have it
    std::optional<double> step_error{};  ///< as of StepError
  };
  /// How far a motion of the oscillating engine depends on its points and steps: largest differences of two accuracies over time.
  struct StepError {
    double speed;      ///< [rad/s]
    double angle;      ///< [rad]
    double amplitude;  ///< of either wave [m]
  };
  /// A loop that changed the drive.
  struct Loop {
    motion::Actuator actuator{};    ///< what it changed
    motion::LoopGains gains{};      ///< those in use
    motion::LoopPlant plant{};      ///< where they and the margins hold
    motion::LoopMargins margins{};  ///< of the linear plant there
  };
  /// What a loop is asked for.
  struct Reference {
    MotionControl::Kind kind;  ///< what it is the reference of
    double value;              ///< speed [rad/s] or angle [rad]
  };
  /// One motor.
  struct Member {
    double value{0};                  ///< of the family's parameter, SI; NaN for the motor alone
    motion::Motion motion{};          ///< samples and events
    std::vector<Measure> measures{};  ///< in the order asked
    double opening_amplitude{0};      ///< A_1 [m]
    double holding_torque{0};         ///< without a wave [N m]
    std::optional<double> off_at{};   ///< when the drive was switched off last [s]
    std::optional<StepError> step_error{};  ///< with the oscillating engine
    std::optional<Loop> loop{};             ///< of a motion under control
  };
  std::optional<StoredColumn> family;                           ///< nothing for the motor alone
  motion::MotionEngine engine{motion::MotionEngine::averaged};  ///< of all motions
  double accuracy{1};                                           ///< of the oscillating engine
  std::optional<Reference> reference{};  ///< of a motion under control, at the end
  double duration{0};                    ///< [s]
  double step{0};                        ///< between samples [s]
  std::vector<Member> members;           ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
