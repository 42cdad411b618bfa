// SPDX-License-Identifier: Apache-2.0
#include "results/stored_summary.hpp"

#include "store/written_content.hpp"

#include <twum/io/result_store.hpp>

namespace twum::inline v0_1::studies {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kDeepest = 64;  // levels; a summary has about ten

[[noreturn]] void refuse(const std::string& path, const std::string& why) {
  throw StoreError(path + ": is damaged: " + why);
}

Json parsed(const std::string& path) {
  const auto level = [&](int depth, Json::parse_event_t, Json&) {
    if (depth > kDeepest)
      refuse(path, "it is nested more than " + std::to_string(kDeepest) + " levels deep");
    return true;
  };
  return Json::parse(written_content(path), level, false);
}

}  // namespace

Json stored_summary(const std::string& path) {
  Json json = parsed(path);
  if (!json.is_object()) refuse(path, "not a JSON object");
  for (const char* name : {"study", "kind", "outcome"})
    if (json.contains(name) && !json[name].is_string())
      refuse(path, "'" + std::string(name) + "' is not a text");
  return json;
}

}  // namespace twum::inline v0_1::studies
