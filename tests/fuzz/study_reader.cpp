// SPDX-License-Identifier: Apache-2.0
#include "entries/resolved_study.hpp"
#include "fuzz/readers.hpp"
#include "fuzz/targets.hpp"
#include "kinds/rows/executor.hpp"

#include <memory>

namespace twum::fuzz {
namespace {

using namespace twum::studies;

// Files that a study may name stand here.
constexpr const char* kFolder = TWUM_SOURCE_DIR "/examples/studies";

StudyFile study_of(const std::string& text) {
  return read_study(Source("study.yaml", text), kFolder);
}

// Begins a run and stops it before its first design.
void run_stopped(StudyKindRun& kind) {
  ResultStore store(":memory:", kind.columns());
  std::stop_source stop;
  stop.request_stop();
  ThreadExecutor executor(kind);
  RunContext context{store, executor, stop.get_token(), {}};
  kind.run(context);
}

// The resolved study is a study file of the same study.
void expect_same(const StudyFile& file) {
  const ResolvedStudy resolved = resolve(file);
  if (resolve(study_of(resolved.text())).hash() != resolved.hash())
    throw BrokenLaw("another study when resolved:\n" + resolved.text());
}

}  // namespace

void feed_study(std::string_view text) {
  std::unique_ptr<StudyKindRun> kind;
  StudyFile file;
  try {
    file = study_of(std::string(text));
    kind = make_kind(file);
  } catch (const InputError&) {  // FileError among them, and named files that cannot be read
    return;
  }
  run_stopped(*kind);
  expect_same(file);
}

}  // namespace twum::fuzz
