// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace twum::inline v0_1::cli {

/// Runs CalculiX on decks, as many at once as there are processors. Its results and what it prints (NAME.log) stand beside them.
/// @param folder  of the decks
/// @param names   of the decks, without the ending .inp
/// @throws OutputError if CalculiX is missing, fails, or takes more than half an hour; studies::Interrupted after a stop request
void run_calculix(const std::string& folder, const std::vector<std::string>& names);

}  // namespace twum::inline v0_1::cli
