// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/core/frequency_response.hpp>

#include <span>
#include <string>

namespace twum::inline v0_1::motors {

/// One quantity of a frequency response.
struct FrequencyColumn {
  const char* name;  ///< as in files
  const char* unit;  ///< SI
  /// Its value at a wave, SI.
  double (*value)(const ResponsePoint&);
  bool of_imbalance{false};  ///< meaningful only if phases or modes are unequal
};

/// frequency, amplitude, speed, torque, powers, currents, backward wave, phase, efficiency and squeal rate, in the order of
/// tables and files. Static lifetime.
std::span<const FrequencyColumn> frequency_columns();

/// The wave with which a motor runs at a frequency [Hz]: the largest stable one; none if no wave is stable there.
std::optional<ResponsePoint> running_point(const FrequencyResponse& response, double frequency);

/// "140 nm, 0 rpm": amplitude and speed of a wave.
std::string wave_text(const ResponsePoint& wave);

/// Whether a backward wave grows beside a wave (D6.7): "by 149 1/s", "no", or "not known" where a layer with damping
/// or inertia sticks somewhere.
std::string squeal_text(const ResponsePoint& wave);

}  // namespace twum::inline v0_1::motors
