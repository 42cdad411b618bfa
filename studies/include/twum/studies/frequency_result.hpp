// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/frequency_response.hpp>
#include <twum/io/column.hpp>

#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// Frequency responses of one motor, or of a family over one parameter. The points of the sweeps are the rows of the store:
/// stage is the sweep, index the frequency.
struct FrequencyResult {
  /// A jump of a sweep.
  struct Jumped {
    bool rising;  ///< whether it belongs to the sweep with rising frequency
    Jump jump;    ///< end of the branch, and where the sweep continues
  };
  /// One motor.
  struct Member {
    double value{0};      ///< of the family's parameter or load, SI; NaN for the motor alone
    double frequency{0};  ///< of its drive [Hz]
    std::optional<ResponsePoint> running;  ///< its largest stable wave at that frequency
    std::optional<double> pull_out_below;  ///< frequency at which the branch of that wave ends [Hz]
    std::vector<Jumped> jumps;             ///< of its sweeps
    std::vector<ResponseBranch> branches;  ///< all its waves, stable or not
  };
  std::optional<StoredColumn>
      family;                   ///< the parameter, or `load_torque`; nothing for the motor alone
  RotorLoad load;               ///< load of the rotor; NaN for a family over the load
  double from{0};               ///< lowest frequency [Hz]
  double to{0};                 ///< highest [Hz]
  std::vector<Member> members;  ///< in the order asked
};

}  // namespace twum::inline v0_1::studies
