// SPDX-License-Identifier: Apache-2.0
#include "results/provenance.hpp"

#include <twum/io/library_versions.hpp>
#include <twum/motion/integrator_version.hpp>
#include <twum/optim/library_versions.hpp>

#include <array>
#include <ctime>

namespace twum::inline v0_1::studies {
namespace {

std::string compiler_text() {
#if defined(__clang__)
  return __VERSION__;  // begins with its name
#else
  return std::string("GCC ") + __VERSION__;
#endif
}

}  // namespace

Json build_json() {
  Json libraries = Json::object();
  for (const optim::LibraryVersion& library : optim::library_versions())
    libraries[library.name] = library.version;
  libraries["SUNDIALS"] = motion::integrator_version();
  for (const auto& [name, version] : file_library_versions()) libraries[name] = version;
  return {{"compiler", compiler_text()}, {"libraries", libraries}};
}

std::string utc_text(std::chrono::system_clock::time_point time) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(time);
  std::tm parts{};
  ::gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  return {text.data(), std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%SZ", &parts)};
}

}  // namespace twum::inline v0_1::studies
