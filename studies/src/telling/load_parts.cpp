// SPDX-License-Identifier: Apache-2.0
#include "telling/load_parts.hpp"

#include <twum/motors/reasons.hpp>

namespace twum::inline v0_1::studies::telling {

double in_celsius(double kelvin) {
  constexpr double kZero = 273.15;
  return kelvin - kZero;
}

Part celsius_part(double kelvin, int digits) {
  return value_part(in_celsius(kelvin), "degC", digits);
}

TimeUnit time_unit(double seconds) {
  constexpr double kMinute = 60, kHour = 3600;
  if (seconds >= 3 * kHour) return {"h", kHour};
  return seconds >= 3 * kMinute ? TimeUnit{"min", kMinute} : TimeUnit{"s", 1};
}

Part time_part(double seconds) {
  const TimeUnit unit = time_unit(seconds);
  return value_part(seconds / unit.seconds, unit.unit, seconds >= 1000 * unit.seconds ? 4 : 3);
}

Phrase load_phrase(const LoadPoint& load) {
  if (load.argument == Argument::both)
    return {value_part(load.torque, "N.m"), " held at ", value_part(load.at, "rad/s")};
  return {value_part(load.at, load.argument == Argument::torque ? "N.m" : "rad/s")};
}

Phrase end_phrase(EndOfLife end, const std::string& limit) {
  switch (end) {
    case EndOfLife::depth_limit: return {"the depth reaches its limit"};
    case EndOfLife::limit: return {"it violates ", limit_part(limit)};
    case EndOfLife::preload_gone: return {"the spring has relaxed"};
    case EndOfLife::worn_through: return {"the lining is worn through"};
    case EndOfLife::load_lost: return {"the motor no longer carries the load"};
    case EndOfLife::none: break;
  }
  return {"-"};
}

std::string reason_of(const std::string& status) {
  for (const auto& reason : motors::reasons())
    if (status == to_string(reason.status)) return reason.meaning;
  return status;
}

Phrase family_phrase(const std::optional<StoredColumn>& family, double value) {
  if (!family) return {"motor"};
  return {name_part(family->name), " ", value_part(value, family->unit)};
}

}  // namespace twum::inline v0_1::studies::telling
