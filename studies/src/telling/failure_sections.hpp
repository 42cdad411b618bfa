// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/telling.hpp>

#include <vector>

/// What is said of motors that violate a limit; internal.
namespace twum::inline v0_1::studies::telling {

/// A share of failing motors below which they are told in a million.
inline constexpr double kFewViolate = 1e-3;

/// "12 in a million motors violate a limit (between 11 and 13 with 95 % confidence)."
Phrase failing_phrase(const UncertaintyResult& answer);
/// How many motors violate each limit, and the most likely one of them: method `importance`.
Section failure_table_section(const UncertaintyResult& answer);
/// Which tolerance causes the failures; none if there are no failures or only one tolerance.
std::vector<Section> cause_sections(const UncertaintyResult& answer);

}  // namespace twum::inline v0_1::studies::telling
