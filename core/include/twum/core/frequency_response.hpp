// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/metric_value.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/core/operating_point.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1 {

/// What stays constant at the rotor while the drive frequency changes: its speed or its load torque.
struct RotorLoad {
  Argument given{Argument::torque};  ///< Argument::torque or Argument::speed
  double value{0};                   ///< load torque [N m] or rotor speed [rad/s]
};

/// What ends a branch of the response.
enum class BranchEndKind : unsigned char {
  open,     ///< the branch continues beyond the range of frequencies
  fold,     ///< the frequency along the branch turns back (D5.3); a slow sweep jumps here
  growing,  ///< beyond it a disturbed wave grows, or the load accelerates the rotor without limit
  lost      ///< beyond it the rotor cannot carry the load, or the contact has no periodic state
};

/// "open", "fold", "growing" or "lost"; static lifetime.
const char* to_string(BranchEndKind kind) noexcept;

/// A wave that the voltage holds at a frequency.
struct ResponsePoint {
  double frequency;      ///< of the drive [Hz]
  OperatingPoint point;  ///< operating point of the motor; its status is ok
  bool stable;           ///< a disturbed wave returns to it
  /// the backward wave at this point; a point that squeals still counts as stable
  BackwardWave backward;
};

/// Waves along the response curve between two places where the frequency turns back or the stability changes.
struct ResponseBranch {
  bool stable;                        ///< whether all its waves are stable; otherwise none is
  std::vector<ResponsePoint> points;  ///< frequencies rise or fall throughout
  BranchEndKind first_end;            ///< at points.front()
  BranchEndKind last_end;             ///< at points.back()
};

/// A place where a slow sweep leaves its branch.
struct Jump {
  ResponsePoint from;               ///< where the branch ends
  std::optional<ResponsePoint> to;  ///< where the sweep continues; none if there is no steady wave
};

/// Waves and jumps of a slow sweep of the frequency.
struct FrequencySweep {
  /// For each frequency, in the order of the sweep; none where there is no stable wave.
  std::vector<std::optional<ResponsePoint>> points;
  std::vector<Jump> jumps;  ///< in the order of the sweep
};

/// The frequency response of a motor under its voltage at one load of the rotor: every wave, stable or not, over the
/// frequency of the drive (theory of the driven stator, section 5). If the layer's viscosity follows from a loss
/// factor, it changes with the frequency. Immutable.
class FrequencyResponse {
 public:
  /// Computes the response: some milliseconds, times the slices of the track.
  /// @param range  frequencies of interest [Hz]; the default reaches from below the resonances to above all jumps and
  ///         above the drive frequency of the design
  /// @throws InputError with every complaint about the design, for a design without a voltage, a load that is not finite, and
  ///         a range that is empty or has ends that are not positive.
  FrequencyResponse(const MotorDesign& design, const RotorLoad& load,
                    const std::optional<std::pair<double, double>>& range = {});
  /// Whether there is a response of a valid design with a voltage, without computing it. An end that is not given counts as
  /// the frequency of the drive.
  /// @throws InputError if a resonance of driver_inductance with blocked_capacitance lies in the range
  static void check(const MotorDesign& design, std::optional<double> from,
                    std::optional<double> to);
  ~FrequencyResponse();
  /// An object that was moved from may only be destroyed or assigned to.
  /// @{
  FrequencyResponse(FrequencyResponse&&) noexcept;
  FrequencyResponse& operator=(FrequencyResponse&&) noexcept;
  /// @}

  /// Ends of the range of frequencies [Hz].
  /// @{
  double from() const noexcept;
  double to() const noexcept;
  /// @}

  /// Every branch in the range, in order along the response curve.
  std::vector<ResponseBranch> branches() const;
  /// Every wave at a frequency [Hz], the smallest first; empty outside the range.
  std::vector<ResponsePoint> at(double frequency) const;
  /// A slow sweep through frequencies [Hz] in rising or falling order. It begins on the smallest stable wave if the frequency
  /// rises, and on the largest if it falls. Where its branch ends it goes on with the stable wave of the nearest amplitude.
  /// @throws InputError for fewer than two frequencies, or frequencies in no order
  FrequencySweep sweep(std::span<const double> frequencies) const;

  /// The frequency below which a wave pulls out [Hz]: the fold at the lower end of its branch. None if the branch
  /// does not end in a fold there.
  std::optional<double> pull_out_below(const ResponsePoint& point) const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
};

/// Equally spaced frequencies, both ends included [Hz].
/// @param points  at least 2
std::vector<double> spaced_frequencies(double from, double to, std::size_t points);

}  // namespace twum::inline v0_1
