// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "results/answers.hpp"

#include <chrono>
#include <string>

namespace twum::inline v0_1::studies {

/// What this program was built from: {"compiler": ..., "libraries": {name: version}}.
Json build_json();

/// "2026-01-31T12:00:00Z"
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace twum::inline v0_1::studies
