// SPDX-License-Identifier: Apache-2.0
#include <twum/optim/library_versions.hpp>

#include <nlopt.h>

namespace twum::inline v0_1::optim {
namespace {

std::string nlopt_text() {
  int major = 0;
  int minor = 0;
  int fix = 0;
  nlopt_version(&major, &minor, &fix);
  return std::to_string(major) + "." + std::to_string(minor) + "." + std::to_string(fix);
}

}  // namespace

std::vector<LibraryVersion> library_versions() {
  return {{"NLopt", nlopt_text()}, {"Ipopt", TWUM_IPOPT_VERSION}, {"GSL", TWUM_GSL_VERSION}};
}

}  // namespace twum::inline v0_1::optim
