// SPDX-License-Identifier: Apache-2.0
#include "report/track.hpp"

#include "report/encode.hpp"

#include <twum/core/parameters.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// Cells of some five pixels, and a frame every 5 % of the speed: 300 kB in the page.
constexpr std::size_t kRadii = 33;
constexpr double kPhases = 81;
constexpr std::size_t kSpeeds = 21;
constexpr float kNoNumber = std::numeric_limits<float>::quiet_NaN();

std::vector<double> radii_of(const MotorDesign& design) {
  const double middle = design.stator.contact_radius;
  const double width = design.stator.contact_width;
  std::vector<double> list;
  for (std::size_t i = 0; i < kRadii; ++i)
    list.push_back(std::lerp(middle - 0.5 * width, middle + 0.5 * width,
                             static_cast<double>(i) / static_cast<double>(kRadii - 1)));
  return list;
}

// Half the width of the window over the widest contact [rad].
double track_window(const Motor& motor, std::span<const double> radii) {
  double widest = 0;
  for (const double radius : radii)
    for (const Zone& zone : motor.fields(0, 2, radius).zones)
      widest = std::max({widest, std::fabs(zone.from), std::fabs(zone.to)});
  return std::min(std::numbers::pi, 1.1 * std::max(widest, motor.contact().half_angle));
}

struct Frame {
  std::vector<float> phase, pressure, slip;
  Json zones = Json::array();
  bool answered{true};
};

Frame frame_of(const Motor& motor, double speed, std::span<const double> radii, double window) {
  const int count = static_cast<int>(std::min(kPhases * std::numbers::pi / window, 20000.0));
  Frame frame;
  for (const double radius : radii) {
    const ContactFields fields = motor.fields(speed, count, radius);
    frame.answered = frame.answered && fields.point.status == PointStatus::ok;
    frame.phase.clear();
    for (const FieldSample& s : fields.samples) {
      if (std::fabs(s.phase) > window) continue;
      const bool touches = s.pressure > 0;
      frame.phase.push_back(static_cast<float>(s.phase));
      frame.pressure.push_back(touches ? static_cast<float>(s.pressure) : kNoNumber);
      const double slip = std::fabs(s.layer_velocity - s.stator_velocity);
      frame.slip.push_back(touches ? static_cast<float>(slip) : kNoNumber);
    }
    Json row = Json::array();
    for (const Zone& zone : fields.zones)
      row.push_back({static_cast<int>(zone.state), zone.from, zone.to});
    frame.zones.push_back(std::move(row));
  }
  return frame;
}

}  // namespace

Json track_json(const Motor& motor) {
  if (motor.radial_slices() == 1) return nullptr;
  const std::vector<double> radii = radii_of(motor.design());
  const double window = track_window(motor, radii);
  if (!(window > 0)) return nullptr;
  Json json{{"radius", base64(std::vector<float>(radii.begin(), radii.end()))}};
  Json frames = Json::array();
  for (const double speed : curve_speeds(motor, kSpeeds)) {
    const Frame frame = frame_of(motor, speed, radii, window);
    if (!frame.answered) continue;
    if (frames.empty()) {
      json["phase"] = base64(frame.phase);
      json["pressure"] = base64(frame.pressure);
    }
    frames.push_back({{"speed", speed}, {"slip", base64(frame.slip)}, {"zones", frame.zones}});
  }
  if (frames.empty()) return nullptr;
  json["frames"] = std::move(frames);
  return json;
}

Json one_slice_torque_json(const Motor& motor, std::span<const double> speeds) {
  if (motor.radial_slices() == 1) return nullptr;
  const Motor slice(with(motor.design(), Parameter::radial_slices, 1));
  std::vector<double> torques;
  for (const double speed : speeds) torques.push_back(slice.operating_point(speed).torque);
  return base64(torques);
}

}  // namespace twum::inline v0_1::studies
