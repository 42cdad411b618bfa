// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/life_result.hpp>
#include <twum/studies/telling.hpp>

namespace twum::inline v0_1::studies::telling {

/// What each radius of a track does that wears freely: depths and pressures when new, after run-in and at the end.
Section free_track_section(const LifeResult::FreeTrack& track);

}  // namespace twum::inline v0_1::studies::telling
