// SPDX-License-Identifier: Apache-2.0
// Runs a study file and uses its result as an object.
#include <twum/twum.hpp>

#include <cstdio>

int main(int argc, char** argv) try {
  using namespace twum::studies;
  if (argc < 2) throw twum::InputError("which study? study STUDY.yaml [DIRECTORY]");
  const StudyFile file = read_study_file(argv[1]);
  const StudyResult result = argc > 2 ? run_study(file, argv[2]) : run_study(file);
  std::printf("%s, %llu evaluations: %s\n", std::string(to_string(result.kind)).c_str(),
              static_cast<unsigned long long>(result.evaluations), result.outcome.c_str());
  if (const auto* answer = std::get_if<OptimizeResult>(&result.answer)) {
    for (const NamedValue& value : answer->best.design)
      std::printf("%s %s\n", value.name.c_str(),
                  parameter_text(value.name, value.value, value.unit).c_str());
  }
} catch (const twum::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 2;
}
