// SPDX-License-Identifier: Apache-2.0
#include "results/stored_summary.hpp"

#include <twum/studies/store/result_store.hpp>

#include <fstream>
#include <sstream>

namespace twum::studies {

nlohmann::ordered_json stored_summary(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  if (!file || !(text << file.rdbuf())) throw StoreError(path + ": cannot be read");
  nlohmann::ordered_json json = nlohmann::ordered_json::parse(text.str(), nullptr, false);
  if (!json.is_object()) throw StoreError(path + ": is damaged: not a JSON object");
  return json;
}

}  // namespace twum::studies
