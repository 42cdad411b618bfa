// SPDX-License-Identifier: Apache-2.0
#include "fmu/fmu.hpp"

#include "fmu/archive.hpp"
#include "fmu/compiler.hpp"
#include "fmu/contact_source.hpp"
#include "fmu/model_description.hpp"
#include "fmu/sources.hpp"

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>

#include <cctype>
#include <utility>
#include <vector>

namespace twum::inline v0_1::cli {
namespace {

// The platform of this machine as FMI 2.0 calls it; empty for those of which no binary was tried.
constexpr const char* kPlatform =
#if defined __linux__ && defined __x86_64__
    "linux64";
#else
    "";
#endif

std::string c_identifier(const std::string& name) {
  std::string identifier;
  for (const char c : name)
    identifier += std::isalnum(static_cast<unsigned char>(c)) != 0 ? c : '_';
  const bool starts_well =
      !identifier.empty() && std::isalpha(static_cast<unsigned char>(identifier[0])) != 0;
  return starts_well ? identifier : "motor_" + identifier;
}

// The same motor has the same identity, whoever exports it.
std::string guid_of(const std::string& content) {
  const boost::uuids::name_generator_sha1 generate(boost::uuids::ns::oid());
  return to_string(generate(content));
}

}  // namespace

Fmu make_fmu(const PlantMotor& motor, const std::string& name) {
  FmuIdentity identity{name, c_identifier(name), ""};
  const std::string unsigned_description = model_description(motor, identity);
  identity.guid = guid_of(unsigned_description + contact_source(motor, "") + plant_header() +
                          plant_source() + fmi_source());
  const std::vector<SourceFile> sources{{"plant.h", plant_header()},
                                        {"plant.c", plant_source()},
                                        {"fmi2.c", fmi_source()},
                                        {"contact_table.c", contact_source(motor, identity.guid)}};
  Fmu fmu;
  std::vector<SourceFile> files{{"modelDescription.xml", model_description(motor, identity)}};
  for (const auto& [file, text] : sources) files.emplace_back("sources/" + file, text);
  Compiled compiled;
  if (*kPlatform == '\0')
    compiled.problem = "binaries are made for Linux on x86-64 only";
  else
    compiled = compile_shared_library(sources);
  fmu.problem = compiled.problem;
  if (!compiled.binary.empty()) {
    fmu.platform = kPlatform;
    files.emplace_back(std::string("binaries/") + kPlatform + "/" + identity.identifier + ".so",
                       compiled.binary);
  }
  fmu.bytes = zip_archive(files);
  return fmu;
}

}  // namespace twum::inline v0_1::cli
