// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::cli {

/// The first Ctrl-C (or SIGTERM) sets a flag, so that what is in flight can be finished and written;
/// the second ends the program. A closed pipe becomes an error of the write.
void install_interrupt_handler();

/// True once the program was asked to stop.
bool interrupted() noexcept;

}  // namespace twum::cli
