// SPDX-License-Identifier: Apache-2.0
#include <twum/core/frequency_response.hpp>

#include "drive/drive.hpp"
#include "drive/frequency_path.hpp"
#include "drive/rules.hpp"
#include "point/operating_point.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

namespace twum::inline v0_1 {
namespace {

using core::PathPiece;
using core::ResponseWave;

constexpr double kTurnOfResponse = 2 * std::numbers::pi;

void require_sweepable(const MotorDesign& design, const RotorLoad& load) {
  const std::vector<std::string> wrong = complaints(design);
  if (!wrong.empty()) throw InputError("motor design: " + wrong.front());
  if (!design.stator.voltage)
    throw InputError(
        "a frequency response needs a motor with a voltage; this one has an amplitude");
  if (load.given != Argument::torque && load.given != Argument::speed)
    throw InputError("the load of a frequency response is a torque or a speed");
  if (!std::isfinite(load.value)) throw InputError("the load must be a finite number");
}

// Frequencies in [rad/s]; the bounds are those of DrivenWaves::own_side().
void require_one_resonance(const std::pair<double, double>& bounds, double from, double to) {
  if (from >= bounds.first && to <= bounds.second) return;
  const auto hertz = [](double omega) {
    return std::to_string(std::lround(omega / kTurnOfResponse)) + " Hz";
  };
  throw InputError("driver_inductance resonates with blocked_capacitance: a frequency response " +
                   (bounds.first > 0 ? "must begin at " + hertz(bounds.first) + " or above"
                                     : "must end at " + hertz(bounds.second) + " or below") +
                   (from < to ? ", but its range is " + hertz(from) + " to " + hertz(to)
                              : ", but the drive is at " + hertz(to) + "; give a range"));
}

// Upper bound of the resonances: a stator with full contact that sticks all round.
double highest_resonance(const core::DrivenWaves& waves) {
  const auto& m = waves.modes();
  const double free = std::fmax(m.resonance, waves.resonance());
  return std::sqrt(free * free + waves.contact_stiffness() / m.mass);
}

}  // namespace

const char* to_string(BranchEndKind kind) noexcept {
  switch (kind) {
    case BranchEndKind::open: return "open";
    case BranchEndKind::fold: return "fold";
    case BranchEndKind::growing: return "growing";
    case BranchEndKind::lost: return "lost";
  }
  return "open";
}

struct FrequencyResponse::Content {
  core::DrivenWaves waves;
  RotorLoad load;
  std::pair<double, double> bounds;  // of DrivenWaves::own_side()
  core::FrequencyPath path;
  double from, to;  // [rad/s]

  Content(const MotorDesign& design, const RotorLoad& rotor_load,
          const std::optional<std::pair<double, double>>& range)
      : waves(core::Drive::waves_of(design)),
        load(rotor_load),
        bounds(waves.own_side()),
        path(waves, load, lowest(range), highest(range)) {
    if (range) {
      from = kTurnOfResponse * range->first, to = kTurnOfResponse * range->second;
      require_one_resonance(bounds, from, to);
      return;
    }
    from = to = waves.omega();
    require_one_resonance(bounds, from, to);
    const auto include = [this](double omega) {
      from = std::fmin(from, omega), to = std::fmax(to, omega);
    };
    for (const double omega : path.resonances()) include(omega);
    for (const PathPiece& piece : path.pieces()) {
      if (piece.first_end == BranchEndKind::fold) include(piece.waves.front().omega);
      if (piece.last_end == BranchEndKind::fold) include(piece.waves.back().omega);
    }
    const double margin = std::fmax(core::kResponseRules.margin * (to - from),
                                    core::kResponseRules.least_margin * waves.omega());
    from = std::fmax(from - margin, bounds.first), to = std::fmin(to + margin, bounds.second);
  }

  double lowest(const std::optional<std::pair<double, double>>& range) const {
    const double own = 0.9 * std::fmin(waves.resonance(), waves.omega());
    return std::fmax(range ? std::fmin(own, kTurnOfResponse * range->first) : own, bounds.first);
  }
  double highest(const std::optional<std::pair<double, double>>& range) const {
    const double own = 1.1 * std::fmax(highest_resonance(waves), waves.omega());
    return std::fmin(range ? std::fmax(own, kTurnOfResponse * range->second) : own, bounds.second);
  }

  ResponsePoint point_of(const ResponseWave& wave) const {
    const auto motor = waves.at_frequency(wave.omega).motor(wave.amplitude);
    const auto solved = core::solve_point(motor, wave.speed, &wave.start);
    OperatingPoint point = core::operating_point_of(motor, solved, wave.speed, &waves.modes());
    // The search for the speed finds the torque to 1e-9. If the rotor stands still, friction balances the load
    // exactly.
    if (load.given == Argument::torque)
      point.torque = load.value, point.output_power = load.value * wave.speed;
    return {wave.frequency(), point, wave.stable,
            core::backward_wave_of(motor, solved, wave.speed, &waves.modes(),
                                   waves.modes().rotor_mass)};
  }

  struct Place {
    const PathPiece* piece;
    ResponseWave wave;
  };
  std::vector<Place> places_at(double omega) const {
    std::vector<Place> found;
    for (const PathPiece& piece : path.pieces()) {
      if (!piece.covers(omega)) continue;
      if (const auto wave = path.at(piece, omega)) found.push_back({&piece, *wave});
    }
    std::sort(found.begin(), found.end(),
              [](const Place& a, const Place& b) { return a.wave.amplitude < b.wave.amplitude; });
    return found;
  }
  std::vector<Place> stable_at(double omega) const {
    std::vector<Place> found = places_at(omega);
    std::erase_if(found, [](const Place& p) { return !p.wave.stable; });
    return found;
  }
  // The place next to the end of a branch, on another branch.
  std::optional<Place> landing(const PathPiece* left, const ResponseWave& end) const {
    std::optional<Place> nearest;
    const auto distance = [&](const Place& p) {
      return std::fabs(p.wave.amplitude - end.amplitude);
    };
    for (const Place& place : stable_at(end.omega))
      if (place.piece != left && (!nearest || distance(place) < distance(*nearest)))
        nearest = place;
    return nearest;
  }
  ResponseBranch branch_of(const PathPiece& piece) const;
};

FrequencyResponse::FrequencyResponse(const MotorDesign& design, const RotorLoad& load,
                                     const std::optional<std::pair<double, double>>& range) {
  require_sweepable(design, load);
  if (range && !(range->first > 0 && range->second > range->first && std::isfinite(range->second)))
    throw InputError("the range of a frequency response must rise from a positive frequency");
  content_ = std::make_unique<const Content>(design, load, range);
}

void FrequencyResponse::check(const MotorDesign& design, std::optional<double> from,
                              std::optional<double> to) {
  const core::DrivenWaves waves = core::Drive::waves_of(design);
  const auto omega = [&](std::optional<double> end) {
    return end ? kTurnOfResponse * *end : waves.omega();
  };
  require_one_resonance(waves.own_side(), omega(from), omega(to));
}

FrequencyResponse::~FrequencyResponse() = default;
FrequencyResponse::FrequencyResponse(FrequencyResponse&&) noexcept = default;
FrequencyResponse& FrequencyResponse::operator=(FrequencyResponse&&) noexcept = default;

double FrequencyResponse::from() const noexcept { return content_->from / kTurnOfResponse; }
double FrequencyResponse::to() const noexcept { return content_->to / kTurnOfResponse; }

// The part of a piece within the range, with a wave added at each end of the range that it crosses.
ResponseBranch FrequencyResponse::Content::branch_of(const PathPiece& piece) const {
  ResponseBranch branch{piece.stable, {}, BranchEndKind::open, BranchEndKind::open};
  std::vector<ResponseWave> inside;
  for (const ResponseWave& wave : piece.waves)
    if (wave.omega >= from && wave.omega <= to) inside.push_back(wave);
  for (const double border : {from, to})
    if (piece.covers(border))
      if (const auto wave = path.at(piece, border)) inside.push_back(*wave);
  std::sort(inside.begin(), inside.end(),
            [](const ResponseWave& a, const ResponseWave& b) { return a.place < b.place; });
  for (const ResponseWave& wave : inside) branch.points.push_back(point_of(wave));
  if (inside.empty()) return branch;
  if (inside.front().place == piece.waves.front().place) branch.first_end = piece.first_end;
  if (inside.back().place == piece.waves.back().place) branch.last_end = piece.last_end;
  return branch;
}

std::vector<ResponseBranch> FrequencyResponse::branches() const {
  std::vector<ResponseBranch> found;
  for (const PathPiece& piece : content_->path.pieces()) {
    ResponseBranch branch = content_->branch_of(piece);
    if (!branch.points.empty()) found.push_back(std::move(branch));
  }
  return found;
}

std::vector<ResponsePoint> FrequencyResponse::at(double frequency) const {
  std::vector<ResponsePoint> found;
  const double omega = kTurnOfResponse * frequency;
  if (!(omega >= content_->from && omega <= content_->to)) return found;
  for (const Content::Place& place : content_->places_at(omega))
    found.push_back(content_->point_of(place.wave));
  return found;
}

FrequencySweep FrequencyResponse::sweep(std::span<const double> frequencies) const {
  if (frequencies.size() < 2) throw InputError("a sweep needs at least two frequencies");
  const bool up = frequencies[1] > frequencies[0];
  for (std::size_t i = 1; i < frequencies.size(); ++i)
    if ((frequencies[i] > frequencies[i - 1]) != up || frequencies[i] == frequencies[i - 1])
      throw InputError("the frequencies of a sweep must rise or fall");
  FrequencySweep sweep;
  const PathPiece* piece = nullptr;
  for (const double frequency : frequencies) {
    const double omega = kTurnOfResponse * frequency;
    for (int i = 0; piece && !piece->covers(omega) && i < core::kResponseRules.most_jumps; ++i) {
      const bool front = (piece->waves.front().omega > piece->waves.back().omega) == up;
      const ResponseWave& end = front ? piece->waves.front() : piece->waves.back();
      const auto next = content_->landing(piece, end);
      Jump jump{content_->point_of(end), {}};
      if (next) jump.to = content_->point_of(next->wave);
      sweep.jumps.push_back(jump);
      piece = next ? next->piece : nullptr;
    }
    if (!piece) {
      const auto stable = content_->stable_at(omega);
      if (!stable.empty()) piece = up ? stable.front().piece : stable.back().piece;
    }
    std::optional<ResponseWave> wave;
    if (piece && piece->covers(omega)) wave = content_->path.at(*piece, omega);
    sweep.points.push_back(wave ? std::optional(content_->point_of(*wave)) : std::nullopt);
  }
  return sweep;
}

std::optional<double> FrequencyResponse::pull_out_below(const ResponsePoint& point) const {
  for (const Content::Place& place : content_->places_at(kTurnOfResponse * point.frequency)) {
    if (std::fabs(place.wave.amplitude - point.point.amplitude) > 1e-6 * point.point.amplitude)
      continue;
    const PathPiece& piece = *place.piece;
    const bool front = piece.waves.front().omega < piece.waves.back().omega;
    if ((front ? piece.first_end : piece.last_end) == BranchEndKind::open) return {};
    return piece.lowest() / kTurnOfResponse;
  }
  return {};
}

std::vector<double> spaced_frequencies(double from, double to, std::size_t points) {
  std::vector<double> frequencies(points);
  for (std::size_t i = 0; i < points; ++i)
    frequencies[i] = from + (to - from) * static_cast<double>(i) / static_cast<double>(points - 1);
  return frequencies;
}

}  // namespace twum::inline v0_1
