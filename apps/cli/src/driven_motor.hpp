// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::cli {

/// The example of a motor under a voltage, as a file to start from; static lifetime.
const char* driven_motor_text();

}  // namespace twum::cli
