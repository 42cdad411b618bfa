// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/io/result_store.hpp>

#include <nlohmann/json.hpp>

#include <string>

namespace twum::inline v0_1::studies {

/// The content of a summary.json.
/// @throws StoreError if it cannot be read or is no JSON object
nlohmann::ordered_json stored_summary(const std::string& path);

/// Calls a function that takes values out of a summary.
/// @throws StoreError in place of the exceptions of the JSON library
template <typename Use>
auto from_summary(const std::string& path, Use use) {
  try {
    return use();
  } catch (const nlohmann::json::exception&) {
    throw StoreError(path +
                     ": is damaged: an entry is missing or of another type than twum writes");
  }
}

}  // namespace twum::inline v0_1::studies
