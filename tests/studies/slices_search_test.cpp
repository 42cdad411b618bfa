// SPDX-License-Identifier: Apache-2.0
// Searches of a motor whose number of slices is `auto`.
#include "search_support.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/settings.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/verify_study.hpp>

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

// Both end where the certificate's tolerance of 1e-8 allows, on a goal whose curvature is of order one on the scale of the search:
// designs then agree to its root, 1e-4, and goals to 1e-8.
TEST_CASE("a search continues with the number of nodes that auto takes at its end",
          "[studies][slices]") {
  const Search counted(narrow_ring("auto"));
  CHECK(counted.answer.outcome == "optimal");
  const auto& best = counted.optimum().best;
  const int slices = static_cast<int>(test::value(best.design, "radial_slices"));
  MotorDesign there = narrow_ring("auto").motor.design;
  there.preload = test::value(best.design, "preload");
  CHECK(Motor(there).radial_slices() >= slices);
  REQUIRE(slices < kAutoSlices);  // not what a search begins with
  const Search given(narrow_ring(slices_text(slices)));
  CHECK(test::value(given.optimum().best.design, "preload") == Approx(there.preload).epsilon(1e-4));
  for (const NamedValue& each : given.optimum().best.metrics)
    CHECK(test::value(best.metrics, each.name) == Approx(each.value).epsilon(1e-4));
  CHECK(test::value(best.metrics, "peak_power") ==
        Approx(test::value(given.optimum().best.metrics, "peak_power")).epsilon(1e-8));
}

TEST_CASE("a search interrupted anywhere continues to the same answer with more slices",
          "[studies][slices]") {
  const StudyFile file = narrow_ring("auto");
  const Search whole(file);
  const std::vector<StoredRow> rows = whole.rows();
  for (const std::size_t kept : {std::size_t{3}, rows.size() / 2, rows.size() - 2}) {
    const Search on(file, 1, {rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(kept)});
    CHECK(on.json() == whole.json());
    CHECK(on.store->rows() == rows.size());
  }
}

TEST_CASE("a front holds the number of slices that auto takes where it begins",
          "[studies][slices]") {
  const auto front = [](const std::string& slices) {
    return test::study_of(
        "ring-60", "{contact_width: 1.5 mm, radial_slices: " + slices + "}",
        "{kind: pareto, variables: {preload: {min: 100 N, max: 220 N}}, "
        "objectives: [maximize: peak_power, maximize: no_load_speed], points: 3}");
  };
  const StudyFile file = front("auto");
  const int slices = Motor(file.motor.design).radial_slices();
  const Search counted(file), given(front(slices_text(slices)));
  const auto &points = counted.front().front, &others = given.front().front;
  REQUIRE(points.size() == others.size());
  // The same function of the design: the same search, to the bit.
  for (std::size_t i = 0; i < points.size(); ++i) {
    CHECK(test::value(points[i].report.design, "radial_slices") == slices);
    for (const NamedValue& each : others[i].report.metrics)
      CHECK(test::value(points[i].report.metrics, each.name) == each.value);
  }
  CHECK(counted.store->rows() == given.store->rows());
  // Said as a motor file says it.
  CHECK_THAT(counted.text(), Catch::Contains("  " + slices_text(slices)));
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
