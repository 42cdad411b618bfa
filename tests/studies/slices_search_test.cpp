// SPDX-License-Identifier: Apache-2.0
// Searches of a motor whose number of slices is `auto`.
#include "search_support.hpp"

#include <twum/core/performance/motor.hpp>
#include <twum/studies/run/run_study.hpp>
#include <twum/studies/run/verify_study.hpp>

#include <catch2/catch.hpp>

#include <string>

using namespace twum;
using namespace twum::studies;
using Catch::Contains;
using test::ScratchFolder;
using test::Search;

namespace {

constexpr const char* kQuestion =
    "{kind: optimize, variables: {preload: {min: 100 N, max: 220 N}}, maximize: peak_power, "
    "constraints: [no_load_speed >= 100 rpm], solver: {name: auto, starts: 1}";

StudyFile narrow_ring(const std::string& slices, const std::string& more = "") {
  return test::study_of("ring-60", "{contact_width: 1.5 mm, radial_slices: " + slices + "}",
                        kQuestion + more + "}");
}

}  // namespace

TEST_CASE("a search holds the number of slices that auto takes where it begins",
          "[studies][slices]") {
  const StudyFile file = narrow_ring("auto");
  const int slices = Motor(file.motor.design).radial_slices();
  REQUIRE(slices > 1);
  const Search counted(file), given(narrow_ring(std::to_string(slices)));
  CHECK(counted.answer.outcome == "optimal");
  // The same function of the design: the same search, to the bit.
  CHECK(test::value(counted.optimum().best.design, "radial_slices") == slices);
  for (const NamedValue& each : given.optimum().best.design)
    CHECK(test::value(counted.optimum().best.design, each.name) == each.value);
  for (const NamedValue& each : given.optimum().best.metrics)
    CHECK(test::value(counted.optimum().best.metrics, each.name) == each.value);
  CHECK(counted.store->rows() == given.store->rows());
}

TEST_CASE("an answer with a found number of slices can be verified and started from",
          "[studies][slices]") {
  const ScratchFolder folder;
  const StudyFile file = narrow_ring("auto");
  const StudyResult result = run_study(file, folder.path("out"));
  CHECK(result.outcome == "optimal");
  const Verification found = verify_study(folder.path("out"));
  CHECK(found.complaints.empty());
  CHECK(found.certificates == 1);
  // From its answer on, the number is found there.
  const Search on(narrow_ring("auto", ", start: " + folder.path("out")));
  CHECK(on.answer.outcome == "optimal");
  CHECK(on.optimum().best.design.size() == 2);  // the preload and the slices, each once
  const double before =
      test::value(std::get<OptimizeResult>(result.answer).best.metrics, "peak_power");
  // `auto` promises 1e-6 of the scale of powers, of which the peak is some tenths.
  CHECK(test::value(on.optimum().best.metrics, "peak_power") == Approx(before).epsilon(1e-5));
}
