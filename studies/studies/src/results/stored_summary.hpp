// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <nlohmann/json.hpp>

#include <string>

namespace twum::studies {

/// The content of a summary.json.
/// @throws StoreError if it cannot be read or is no JSON object
nlohmann::ordered_json stored_summary(const std::string& path);

}  // namespace twum::studies
