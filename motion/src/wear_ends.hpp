// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/life.hpp>
#include <twum/core/track_wear.hpp>

#include <functional>
#include <optional>
#include <span>
#include <vector>

namespace twum::inline v0_1::motion {

/// What may end the life of a track of which each radius wears by itself.
struct WearEnd {
  EndOfLife end{EndOfLife::none};  ///< none where the wear localizes
  std::size_t limit{0};            ///< which of Wear::until
  bool localizes{false};           ///< a node carries more than three times its even share
};

/// The same at a time [s].
struct WearEndAt {
  WearEnd which;
  double time;
};

/// The depths of the nodes at a time within a step.
using DepthsAt = std::function<std::vector<double>(double time)>;

/// Watches the limits of a life from step to step.
class WearEnds {
 public:
  /// @param first  rates of the new motor; @param track  has to outlive this, as has the design
  WearEnds(const MotorDesign& design, TrackWear& track, const TrackRates& first);

  /// The first limit in their order that depths break.
  std::optional<WearEnd> first_broken(std::span<const double> depths);
  /// The one that is reached first in a step at whose beginning none is broken: by the sign of its margin at the end.
  /// @param depths_at  the step's dense output
  std::optional<WearEndAt> within(const DepthsAt& depths_at, double begin, double end,
                                  bool beyond_localization);
  /// Largest load of a node in parts of its even share.
  double largest_share(const std::vector<TrackLoad>& loads) const;

 private:
  double margin(const WearEnd& limit, std::span<const double> depths);
  double margin_of_until(std::size_t limit, std::span<const double> depths) const;

  const MotorDesign& design_;
  TrackWear& track_;
  std::vector<std::vector<double>>
      even_;  // what each node carries of its even share, for each load [N]
  std::vector<WearEnd> limits_;
};

}  // namespace twum::inline v0_1::motion
