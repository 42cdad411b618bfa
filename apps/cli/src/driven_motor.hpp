// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::cli {

/// The template of a motor file for a motor under a voltage; static lifetime.
const char* driven_motor_text();

}  // namespace twum::cli
