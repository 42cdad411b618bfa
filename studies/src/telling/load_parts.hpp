// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/life.hpp>
#include <twum/io/column.hpp>
#include <twum/studies/telling.hpp>

#include <optional>
#include <string>

/// Parts that tell loads, lives, times and temperatures; internal.
namespace twum::inline v0_1::studies::telling {

/// An absolute temperature in degrees.
Part celsius_part(double kelvin, int digits = 3);
/// The same number, for charts.
double in_celsius(double kelvin);

/// A unit in which a time is read, and its seconds.
struct TimeUnit {
  const char* unit;
  double seconds;
};
TimeUnit time_unit(double seconds);
Part time_part(double seconds);

/// "0.5 N.m", "100 rpm", "0.5 N.m held at 100 rpm"
Phrase load_phrase(const LoadPoint& load);

/// What ends a life: "the depth reaches its limit", "it violates start_voltage <= 120 V".
/// @param limit  of Wear::until, as typed
Phrase end_phrase(EndOfLife end, const std::string& limit);

/// What a status of a metric means; the status itself where it has no meaning of its own.
std::string reason_of(const std::string& status);

/// "voltage 80 V"; the motor alone has no name.
Phrase family_phrase(const std::optional<StoredColumn>& family, double value);

}  // namespace twum::inline v0_1::studies::telling
