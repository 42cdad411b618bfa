// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace twum {

/// What the rotor does while the frequency of the drive moves: it turns at a speed, or carries a torque.
struct RotorLoad {
  Argument given{Argument::torque};  ///< Argument::torque or Argument::speed
  double value{0};                   ///< load torque [N m] or rotor speed [rad/s]
};

/// What ends a branch of the response.
enum class BranchEndKind : unsigned char {
  open,     ///< nothing: the branch goes on beyond what was looked at
  fold,     ///< the frequency turns back (D5.3): a slow sweep jumps here
  growing,  ///< beyond, a disturbed wave grows, or the load runs away with the rotor
  lost      ///< beyond, the rotor cannot carry the load or the contact has no periodic state
};

/// "open", "fold", "growing" or "lost"; a static text.
const char* to_string(BranchEndKind kind) noexcept;

/// A wave that the voltage holds at a frequency.
struct ResponsePoint {
  double frequency;       ///< of the drive [Hz]
  OperatingPoint point;   ///< the motor there; its status is ok
  bool stable;            ///< a disturbed wave comes back to it
  BackwardWave backward;  ///< beside it; a wave that squeals counts as stable
};

/// Waves from one turn of the frequency to the next.
struct ResponseBranch {
  bool stable;                        ///< all of them, or none
  std::vector<ResponsePoint> points;  ///< frequencies rise or fall throughout
  BranchEndKind first_end;            ///< at points.front()
  BranchEndKind last_end;             ///< at points.back()
};

/// A place where a slow sweep leaves its branch.
struct Jump {
  ResponsePoint from;  ///< where the branch ends
  std::optional<ResponsePoint>
      to;  ///< where the sweep goes on; none if no steady wave is left there
};

/// What a slow sweep of the frequency passes through.
struct FrequencySweep {
  /// For each frequency, in the order of the sweep; none where there is no stable wave.
  std::vector<std::optional<ResponsePoint>> points;
  std::vector<Jump> jumps;  ///< in the order of the sweep
};

/// The frequency response of a motor under its voltage at one load of the rotor: every wave, stable or not, over the frequency
/// of the drive (theory of the driven stator, section 5). The layer's viscosity follows the frequency where it is that of a
/// loss factor. Immutable.
class FrequencyResponse {
 public:
  /// Computes the response: some milliseconds, times the slices of the track.
  /// @param range  frequencies that count [Hz]; without it from below the resonances to above all jumps and the drive's own
  /// @throws InputError with every complaint about the design, for a design without a voltage, a load that is not finite, and
  ///         a range that is empty or has ends that are not positive.
  FrequencyResponse(const MotorDesign& design, const RotorLoad& load,
                    const std::optional<std::pair<double, double>>& range = {});
  ~FrequencyResponse();
  /// What is left behind may only be destroyed or assigned to.
  /// @{
  FrequencyResponse(FrequencyResponse&&) noexcept;
  FrequencyResponse& operator=(FrequencyResponse&&) noexcept;
  /// @}

  /// The frequencies that count lie between these [Hz].
  /// @{
  double from() const noexcept;
  double to() const noexcept;
  /// @}

  /// Every branch in the range, along the path of growing and falling amplitude.
  std::vector<ResponseBranch> branches() const;
  /// Every wave at a frequency [Hz], the smallest first; empty outside the range.
  std::vector<ResponsePoint> at(double frequency) const;
  /// A slow sweep through frequencies [Hz] in rising or falling order. It begins on the smallest stable wave if the frequency
  /// rises, and on the largest if it falls. Where its branch ends it goes on with the stable wave of the nearest amplitude.
  /// @throws InputError for fewer than two frequencies, or frequencies in no order
  FrequencySweep sweep(std::span<const double> frequencies) const;

  /// The frequency below which a wave pulls out: the fold at the lower end of its branch [Hz]; none if it does not end there.
  std::optional<double> pull_out_below(const ResponsePoint& point) const;

 private:
  struct Content;
  std::unique_ptr<const Content> content_;
};

/// Equally spaced frequencies, both ends included [Hz].
/// @param points  at least 2
std::vector<double> spaced_frequencies(double from, double to, std::size_t points);

}  // namespace twum
