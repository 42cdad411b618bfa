// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/motion_result.hpp>

#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// What a motion leaves out and has grown in it.
struct MotionNote {
  std::string name;  ///< "motion-too-fast", "squeals-while-moving" or "bounces"
  std::string text;  ///< a sentence
};

/// A note for each kind of event of what the averaged engine leaves out (add_what_is_left_out()).
std::vector<MotionNote> motion_notes(const motion::Motion& motion);

}  // namespace twum::inline v0_1::studies
