// SPDX-License-Identifier: Apache-2.0
// An operating point whose track is split where zones change (W4.4, W4.5).
#include "model/track.hpp"
#include "point/point.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace twum::inline v0_1::core {

using contact::LayerMotion;

namespace {

SliceZones zones_of(const SolvedSlice& s) {
  if (s.locked) return {0, HUGE_VAL};
  return s.state.status != contact::PeriodicStatus::ok
             ? SliceZones{SliceZones::kNoAnswer, HUGE_VAL}
             : SliceZones{s.state.lap.itinerary, s.state.lap.shortest, s.state.laps};
}

}  // namespace

Vector<SliceZones> SolvedPoint::zones_of_slices() const {
  Vector<SliceZones> zones;
  for (std::size_t k = 0; k < size(); ++k) zones.push_back(zones_of(slice(k)));
  return zones;
}

// What the slices at an operating point answer.
class SolvedPoint::Queries final : public SliceQueries {
 public:
  Queries(const SolvedPoint& point, const DrivenMotor<double>& motor,
          std::span<const Slice<double>> slices, double speed, const LayerMotion<double>& layer,
          double accuracy)
      : point_(point),
        motor_(motor),
        slices_(slices),
        speed_(speed),
        layer_(layer),
        accuracy_(accuracy) {}

  SliceZones zones(double radius) const override {
    const Slice<double> there = slice_at(motor_, radius, motor_.b);
    if (!(there.contact.half_angle > 0)) return {0, HUGE_VAL};
    const auto entry = point_.entry_at(slices_, radius);
    return zones_of({motor_, there, speed_, layer_, entry ? &*entry : nullptr, accuracy_});
  }
  std::optional<contact::Jump> jump(double low, double high) const override {
    return contact::jump_between(numbers_at(low), numbers_at(high));
  }
  double margin(double radius, const contact::Jump& jump) const override {
    return contact::jump_margin(numbers_at(radius), jump);
  }

 private:
  contact::ContactNumbers<double> numbers_at(double radius) const {
    return contact_numbers(motor_, slice_at(motor_, radius, motor_.b), speed_);
  }

  const SolvedPoint& point_;
  const DrivenMotor<double>& motor_;
  std::span<const Slice<double>> slices_;
  double speed_;
  const LayerMotion<double>& layer_;
  double accuracy_;
};

void SolvedPoint::split(const DrivenMotor<double>& m, double speed,
                        const LayerMotion<double>& layer, double accuracy) {
  splits_ =
      zone_splits(m, zones_of_slices(), Queries(*this, m, m.slices(), speed, layer, accuracy));
  if (splits_.empty()) return;
  status = PointStatus::ok;
  solve_split(m, speed, layer, nullptr, accuracy);
}

std::optional<WarmStart::Entry> SolvedPoint::entry_at(std::span<const Slice<double>> slices,
                                                      double radius) const {
  const auto far = [radius](const Slice<double>& s) { return std::fabs(s.radius - radius); };
  std::size_t nearest = 0;
  for (std::size_t k = 1; k < size(); ++k)
    if (far(slices[k]) < far(slices[nearest])) nearest = k;
  const SolvedSlice& near = slice(nearest);
  if (!near.helps()) return {};
  return near.start();
}

Vector<Slice<double>> SolvedPoint::solve_split(const DrivenMotor<double>& m, double speed,
                                               const LayerMotion<double>& layer,
                                               const WarmStart* guess, double accuracy) {
  Vector<Slice<double>> slices = annulus_of<double>(m, fixed_places(splits_));
  lever_ = lever_of<double>(slices, m.preload);
  if (guess && guess->size() != slices.size()) guess = nullptr;
  first_ = {};
  solve(m, slices, speed, layer, guess, accuracy, false);
  return slices;
}

bool SolvedPoint::has_pieces_of_splits(const DrivenMotor<double>& m) const {
  return std::all_of(splits_.begin(), splits_.end(),
                     [&m](const Split& s) { return s.piece < m.pieces.size(); });
}

bool SolvedPoint::follow(const DrivenMotor<double>& m, double speed,
                         const LayerMotion<double>& layer, Vector<Split> splits,
                         const WarmStart& guess, double accuracy) {
  if (!has_static_excess(m)) {
    splits_ = std::move(splits);
    solve_split(m, speed, layer, &guess, accuracy);
    return true;
  }
  auto followed =
      followed_splits(m, std::move(splits), Queries(*this, m, m.slices(), speed, layer, 0));
  if (!followed) return false;
  splits_ = std::move(*followed);
  WarmStart start = guess;
  for (std::size_t k = 0; k < start.size(); ++k) start.of_slice(k).decided = true;
  const Vector<Slice<double>> slices = solve_split(m, speed, layer, &start, accuracy);
  return status == PointStatus::ok && change_at_splits(m, splits_, slices, zones_of_slices(),
                                                       Queries(*this, m, slices, speed, layer, 0));
}

}  // namespace twum::inline v0_1::core
