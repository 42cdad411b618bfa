// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "options.hpp"

#include <string>

namespace twum::inline v0_1::cli {

/// What `twum stator --solid` is asked for.
struct SolidRequest {
  const MotorOptions& motor;
  std::string format;  ///< table or json
  std::string folder;  ///< for the files of CalculiX; empty: they are removed
  std::string mesh;    ///< elements through the plate, as typed; empty: the default
  std::size_t modes;   ///< of the solid, to list
  std::string plot;    ///< file of a picture; empty: none
  bool write;          ///< a copy of the motor file with the fitted stiffness_share
};

/// Solves the stator as a solid and prints it beside the plate; returns the exit status.
int run_solid_stator(const SolidRequest& request);

}  // namespace twum::inline v0_1::cli
