// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "contact/contact_numbers.hpp"
#include "contact/layer_motion.hpp"
#include "contact/scalars.hpp"
#include "design/workspace.hpp"

#include <twum/core/zone.hpp>

#include <cstdint>
#include <numbers>

namespace twum::inline v0_1::contact {

/// Where a lap is: phase and layer.
template <typename S>
struct LapPlace : Phase<S> {
  LayerState<S> layer;
};

/// Where a lap begins: the layer's state at entry and, in full contact, the zone it is in.
template <typename S>
struct LapEntry {
  LayerState<S> layer;
  bool carried{false};  ///< full contact: the zone below goes on from the lap before
  ZoneState zone{ZoneState::stick};
  LayerState<S> across{S(0.0), S(0.0)};  ///< of the radial motion
};

/// A zone with what is needed to draw the fields in it.
struct ZoneTrace {
  Zone zone;
  LayerState<double> start;  ///< layer at `zone.from`
};

/// Where each zone of a lap ends, for following it again without a search.
struct ZoneSequence {
  struct End {
    double length;   ///< of the zone [rad]; kNoZero if it lasts to the exit
    float side;      ///< stick: sign of the traction at its threshold
    ZoneState zone;  ///< what it is the end of
  };
  static constexpr int kCapacity = 8;
  ZoneSequence() {}  // the ends are not initialised: laps are many

  End ends[kCapacity];
  int count{0};  ///< zones of the lap; more than kCapacity: the sequence is not complete

  bool complete() const { return count <= kCapacity; }
};

/// True if nothing of the layer's own motion outlives the free flight, as exp(-37) = 9e-17: it enters every contact at rest.
template <typename S>
bool enters_at_rest(const ContactNumbers<S>& n, const LayerMotion<S>& layer) {
  const S flight = 2 * std::numbers::pi - 2.0 * n.half_angle;
  return !n.full && layer.slowest_decay() * value_of(flight) > 37;
}

enum class LapStatus : unsigned char { ok, resonance, unresolved };

/// Fingerprint of a sequence of zones, zone by zone.
/// @{
inline constexpr std::uint64_t kNoZones = 0xcbf29ce484222325ull;
inline std::uint64_t marked(std::uint64_t sequence, std::uint64_t what) {
  return (sequence ^ what) * 0x100000001b3ull;
}
inline std::uint64_t mark_of(ZoneState zone) {
  return zone == ZoneState::slip_plus ? 1 : zone == ZoneState::slip_minus ? 2 : 3;
}
/// @}

/// One turn of the wave: from contact entry through all zones and free flight to the next entry.
template <typename S>
struct Lap {
  Lap() {}  // with `= default`, Lap() would first fill the ends of zones with zeros

  ContactMeans<S> means{S(0.0), S(0.0), S(0.0), S(0.0), S(0.0), S(0.0)};
  LapEntry<S> next{{S(0.0), S(0.0)}};     ///< state at the next entry
  LayerState<S> exit{S(0.0), S(0.0)};     ///< layer where the contact ends
  std::uint64_t itinerary{kNoZones};      ///< fingerprint of the sequence of zones
  int zones{0};                           ///< number of zones
  bool one_slip{false};                   ///< the whole contact slips one way
  double shortest{2 * std::numbers::pi};  ///< length of the shortest zone [rad]
  ZoneState first{ZoneState::stick};      ///< state of the first zone
  LapStatus status{LapStatus::ok};
  bool has_means{true};   ///< false: of the means only the stick length is computed
  ZoneSequence sequence;  ///< of a search in double
};

/// Which means of a lap are asked for.
enum class Means : unsigned char {
  of_wave,  ///< all but friction power and layer loss, which then are NaN where the contact slips
  all
};

/// Follows the layer through one turn; theory sections 4 and 5. Every zone is in closed form, its end
/// a root found in double and given its derivatives by the implicit function theorem.
///
/// @param sequence  ends of the zones if they are known from the same lap in double; else they are searched.
/// @param trace   if not null, the zones are appended to it.
template <typename S>
Lap<S> run_lap(const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
               const LapEntry<S>& entry, const ZoneSequence* sequence = nullptr,
               core::Vector<ZoneTrace>* trace = nullptr, Means means = Means::all);
template <>
Lap<double> run_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                    const LapEntry<double>& entry, const ZoneSequence* sequence,
                    core::Vector<ZoneTrace>* trace, Means means);

/// Phase and layer after the first `zones` zones of a lap; at its end if it has fewer.
template <typename S>
LapPlace<S> place_after(int zones, const ContactNumbers<S>& numbers, const LayerMotion<S>& layer,
                        const LapEntry<S>& entry);
template <>
LapPlace<double> place_after(int zones, const ContactNumbers<double>& numbers,
                             const LayerMotion<double>& layer, const LapEntry<double>& entry);

/// The return map alone: the layer at the next entry, without the means.
/// @param sequence  as in run_lap()
LayerState<StateDual> next_entry(const ContactNumbers<StateDual>& numbers,
                                 const LayerMotion<StateDual>& layer,
                                 const LapEntry<StateDual>& entry, const ZoneSequence* sequence);

/// run_lap() where the ends of the zones are known from a lap nearby, if there is one, but not yet proven to be
/// the first (E3.6).
///
/// @param near  the ends; none: all are searched
Lap<double> prove_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                      const LapEntry<double>& entry, const ZoneSequence& near);

/// A lap of which nothing is known, without any means but the stick length.
Lap<double> search_states(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                          const LapEntry<double>& entry);

/// A lap through the zones of one nearby: it does not search for their ends but follows them to where they have moved (E6.5). A
/// zone that only a search finds may be missing, so confirm the result by prove_lap(). It has the means of the wave. Its status
/// is not ok if it has other zones here.
Lap<double> follow_lap(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                       const LapEntry<double>& entry, const ZoneSequence& near);

/// The same without any means but the stick length, in a quarter of the work of run_lap().
Lap<double> follow_states(const ContactNumbers<double>& numbers, const LayerMotion<double>& layer,
                          const LapEntry<double>& entry, const ZoneSequence& near);

}  // namespace twum::inline v0_1::contact
