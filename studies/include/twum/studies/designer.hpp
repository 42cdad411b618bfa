// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/motors/motor_file.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// Whether this build contains the WebAssembly core for pages. Without it, the page of designer_html() says what is
/// missing.
bool has_designer() noexcept;

/// An interactive page that computes the motor while the user changes its parameters: one file that needs no network.
std::string designer_html(const MotorFile& motor);

}  // namespace twum::inline v0_1::studies
