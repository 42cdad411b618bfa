// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/core/performance/frequency_response.hpp>

#include <span>
#include <string>

namespace twum::studies {

/// One quantity of a frequency response.
struct FrequencyColumn {
  const char* name;  ///< as in files
  const char* unit;  ///< SI
  /// Its value at a wave, SI.
  double (*value)(const ResponsePoint&);
};

/// frequency, amplitude, speed, torque, powers, current, phase and efficiency, in the order of tables and files. Static lifetime.
std::span<const FrequencyColumn> frequency_columns();

/// The wave with which a motor runs at its own frequency: the largest stable one; none if no wave is stable there.
std::optional<ResponsePoint> running_point(const FrequencyResponse& response, double frequency);

/// "140 nm, 0 rpm": amplitude and speed of a wave.
std::string wave_text(const ResponsePoint& wave);

}  // namespace twum::studies
