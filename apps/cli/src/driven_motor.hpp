// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1::cli {

/// The template of a motor file for a motor under a voltage; static lifetime.
const char* driven_motor_text();

}  // namespace twum::inline v0_1::cli
