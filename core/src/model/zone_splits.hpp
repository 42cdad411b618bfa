// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "model/motor_model.hpp"

#include <cstdint>
#include <optional>
#include <span>

namespace twum::inline v0_1::core {

/// What a slice's zones tell of those beside it.
struct SliceZones {
  std::uint64_t signature;  ///< fingerprint of their sequence
  double shortest;          ///< length of the shortest [rad]
  int turns{0};             ///< that it took to find them

  static constexpr std::uint64_t kNoAnswer = ~std::uint64_t{0};
  bool has_answer() const { return signature != kNoAnswer; }
};

/// At this distance from a jump, in parts of a piece, the zones are surely those of one side.
inline constexpr double kBesideJump = 1e-9;

/// What can be asked of slices at radii of the track [m].
class SliceQueries {
 public:
  virtual SliceZones zones(double radius) const = 0;
  /// Asked with mu_0 > mu only: where the laps of two slices part, and the margin of a slice there (W4.5).
  /// @{
  virtual std::optional<contact::Jump> jump(double low, double high) const = 0;
  virtual double margin(double radius, const contact::Jump& jump) const = 0;
  /// @}

 protected:
  ~SliceQueries() = default;
};

/// Where zones appear or vanish along the track (W4.4), as splits of the pieces that touch: to about 1e-6 of a piece. Where the
/// means jump (W4.5): to 1e-10, or to 1e-7 where a state ends because it no longer attracts.
/// @param at_nodes  zones of the motor's slices, in their order
Vector<Split> zone_splits(const DrivenMotor<double>& motor, const Vector<SliceZones>& at_nodes,
                          const SliceQueries& at);

/// The splits of a point nearby (W4.5): those with a jump move to where it is now, the others stay. Nothing if a jump is not found
/// within 0.3 of its piece, or if only the contact on one side of it has its state.
std::optional<Vector<Split>> followed_splits(const DrivenMotor<double>& motor, Vector<Split> splits,
                                             const SliceQueries& at);

/// True if the zones change at all splits with a jump, and nowhere else.
/// @param slices    of the motor with these splits
/// @param at_nodes  their zones
bool change_at_splits(const DrivenMotor<double>& motor, const Vector<Split>& splits,
                      std::span<const Slice<double>> slices, const Vector<SliceZones>& at_nodes,
                      const SliceQueries& at);

}  // namespace twum::inline v0_1::core
