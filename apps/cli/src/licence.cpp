// SPDX-License-Identifier: Apache-2.0
#include "licence.hpp"

#include <twum/base/version.hpp>
#include <twum/motion/integrator_version.hpp>
#include <twum/optim/library_versions.hpp>

#include <algorithm>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

// See docs/decisions/licences.md.
const char* licence(bool gsl, bool ipopt) {
  if (gsl && ipopt)
    return "for your own use: GSL (GPL-3) and Ipopt (EPL) together may not be passed on; the "
           "sources are "
           "under Apache-2.0";
  if (gsl) return "GPL-3, because of GSL; the sources are under Apache-2.0";
  if (ipopt) return "Apache-2.0; Ipopt is under the EPL";
  return "Apache-2.0";
}

}  // namespace

std::string version_text() {
  std::vector<optim::LibraryVersion> linked = optim::library_versions();
  linked.push_back({"SUNDIALS", motion::integrator_version()});
  std::erase_if(linked, [](const auto& library) { return library.version == "none"; });
  const auto has = [&](const char* name) {
    return std::ranges::any_of(linked, [&](const auto& library) { return library.name == name; });
  };
  std::string text = std::string("twum ") + version() + "\nsolvers:";
  for (const optim::LibraryVersion& library : linked)
    text += (&library == linked.data() ? " " : ", ") + library.name + " " + library.version;
  return text + "\nlicence of this program: " + licence(has("GSL"), has("Ipopt"));
}

}  // namespace twum::inline v0_1::cli
