// SPDX-License-Identifier: Apache-2.0
// The summary of a study round its answer: outcome, notes, and where evaluations failed.
#include "answer_support.hpp"
#include "results/row_pass.hpp"

#include <catch2/catch.hpp>

#include <cstdint>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::EndsWith;
using Catch::Matchers::StartsWith;

namespace {

StudyResult study() {
  StudyResult result;
  result.study = "tolerances";
  result.kind = StudyKind::uncertainty;
  result.motor = "ring-60";
  result.outcome = "done";
  result.evaluations = 10;
  result.seconds = 1.25;
  result.answer = UncertaintyResult{};
  return result;
}

void add_region(StudyResult& result, const std::string& reason, std::uint64_t count,
                std::vector<FailureRegion::Range> where = {}) {
  result.failures[reason] = count;
  result.failure_regions.push_back({reason, count, std::move(where)});
}

std::string rows_text(const ResultStore& store, std::size_t variables, std::size_t& pieces) {
  std::string text;
  write_rows(store, store.columns(), variables, [&](std::string_view piece) {
    ++pieces;
    text += piece;
  });
  return text;
}

}  // namespace

TEST_CASE("a summary without an answer is its heading and what it cost",
          "[studies][summary][words]") {
  StudyResult result = study();
  CHECK(summary_text(result) ==
        "tolerances (uncertainty) of ring-60: complete\n\nNo motor was computed.\n\n10 "
        "evaluations in 1.25 s\n");
  result.motor.clear();
  result.evaluations = 1;
  result.outcome = "interrupted";
  CHECK(summary_text(result) ==
        "tolerances (uncertainty): interrupted\n\n"
        "This study was interrupted; these results are incomplete.\n\n"
        "1 evaluation in 1.25 s\n");
}

TEST_CASE("an answer and the doubts about it stand apart", "[studies][summary][words]") {
  StudyResult result = study();
  UncertaintyResult answer;
  answer.samples = 10;
  result.answer = answer;
  result.model_notes = {"Too fast.", "Too thin."};
  CHECK_THAT(summary_text(result), Contains("\nSpread\n10 motors drawn; intervals of 95 %.\n"));
  CHECK_THAT(summary_text(result),
             EndsWith("\n\nnote: Too fast.\nnote: Too thin.\n\n10 evaluations in 1.25 s\n"));
  CHECK(Json::parse(summary_json(result))["model_notes"] == Json{"Too fast.", "Too thin."});
}

TEST_CASE("failures say where in the box they were", "[studies][summary][words]") {
  StudyResult result = study();
  // A range of one value, one of two, and one that no failed row had a value of.
  add_region(result, "lift-off", 3,
             {{{"amplitude", "m"}, 0.8e-6, 1e-6},
              {{"preload", "N"}, 250, 250},
              {{"thickness", "m"}, kNaN, kNaN}});
  add_region(result, "not-periodic", 1, {{{"amplitude", "m"}, kNaN, kNaN}});
  CHECK_THAT(summary_text(result), EndsWith("\n4 failed or incomplete:\n"
                                            "  3  lift-off\n"
                                            "     at amplitude 800 nm to 1 um, preload 250 N\n"
                                            "  1  not-periodic\n"));
  const Json json = Json::parse(summary_json(result));
  CHECK(json["failures"] == Json{{"lift-off", 3}, {"not-periodic", 1}});
  const Json& first = json["failure_regions"][0];
  CHECK(first["reason"] == "lift-off");
  CHECK(first["count"] == 3);
  CHECK(first["where"]["amplitude"] == Json{{"low", 0.8e-6}, {"high", 1e-6}});
  CHECK(first["where"]["thickness"]["low"].is_null());
}

TEST_CASE("of many reasons the first five are shown", "[studies][summary][words]") {
  StudyResult result = study();
  for (int i = 0; i < 5; ++i) add_region(result, "reason " + std::to_string(i), 1);
  CHECK_THAT(summary_text(result), EndsWith("\n5 failed or incomplete:\n  1  reason 0\n"
                                            "  1  reason 1\n  1  reason 2\n  1  reason 3\n"
                                            "  1  reason 4\n"));
  add_region(result, "reason 5", 1);
  CHECK_THAT(summary_text(result),
             EndsWith("  1  reason 4\n  and 1 more reason, see summary.json\n"));
  add_region(result, "reason 6", 1);
  CHECK_THAT(summary_text(result), EndsWith("\n  and 2 more reasons, see summary.json\n"));
  CHECK(Json::parse(summary_json(result))["failure_regions"].size() == 7);
}

TEST_CASE("failures are counted by reason, the most frequent first", "[studies][summary]") {
  FailureCount count({{"amplitude", "m"}, {"preload", "N"}});
  count.see({0, 0, {1e-6, 100}, "ok", {}});
  count.see({0, 1, {1e-6, 150}, "a", {}});
  count.see({0, 2, {2e-6, 100, 7}, "b", {}});  // columns beyond the variables are not looked at
  count.see({0, 3, {1e-6, 300}, "b", {}});
  count.see({0, 4, {3e-6}, "b", {}});  // a row cut short: nothing is known of the preload
  count.see({0, 5, {1e-6, 150}, "c", {}});
  const std::vector<FailureRegion> regions = count.regions();
  REQUIRE(regions.size() == 3);
  CHECK(regions[0].reason == "b");
  CHECK(regions[0].count == 3);
  CHECK(regions[0].where[0].low == 1e-6);
  CHECK(regions[0].where[0].high == 3e-6);
  CHECK(regions[0].where[1].low == 100);
  CHECK(regions[0].where[1].high == 300);
  CHECK(regions[1].reason == "a");  // as often as c: by name
  CHECK(regions[2].reason == "c");
}

TEST_CASE("many reasons are in order of their counts, then of their names", "[studies][summary]") {
  // Reason i is met 1 + 17 i mod 40 times: each number from 1 to 40, and twenty of them once more.
  FailureCount count(std::vector<StoredColumn>{{"preload", "N"}});
  std::uint64_t index = 0;
  for (int i = 0; i < 60; ++i) {
    const std::string reason(1, static_cast<char>('A' + i));
    for (int k = 0; k <= 17 * i % 40; ++k) count.see({0, index++, {100}, reason, {}});
  }
  const std::vector<FailureRegion> regions = count.regions();
  REQUIRE(regions.size() == 60);
  std::uint64_t total = 0;
  for (std::size_t i = 0; i < regions.size(); ++i) {
    total += regions[i].count;
    if (i == 0) continue;
    const FailureRegion& before = regions[i - 1];
    CHECK((before.count > regions[i].count ||
           (before.count == regions[i].count && before.reason < regions[i].reason)));
  }
  CHECK(total == index);
}

TEST_CASE("rows are written with their stage where there is more than one", "[studies][summary]") {
  ResultStore store(":memory:", {{"preload", "N"}, {"stall_torque", "N.m"}});
  store.add({0, 0, {100, 0.5}, "ok", {}});
  store.add({0, 1, {200, kNaN}, "a, b", {}});
  std::size_t pieces = 0;
  CHECK(rows_text(store, 1, pieces) ==
        "preload [N],stall_torque [N.m],status\n100,0.5,ok\n200,,\"a, b\"\n");
  CHECK(pieces == 1);
  store.add({2, 0, {300, 1.5}, "ok", {}});
  CHECK(
      rows_text(store, 1, pieces) ==
      "stage,preload [N],stall_torque [N.m],status\n0,100,0.5,ok\n0,200,,\"a, b\"\n2,300,1.5,ok\n");
}

TEST_CASE("a table of many rows is handed over piece by piece", "[studies][summary]") {
  ResultStore store(":memory:", {{"preload", "N"}});
  std::string expected = "preload [N],status\n";
  for (std::uint64_t i = 0; i < 12000; ++i) {  // of 9 bytes each: 108 kB
    const auto preload = static_cast<double>(10000 + i);
    store.add({0, i, {preload}, "ok", {}});
    expected += std::to_string(10000 + i) + ",ok\n";
  }
  std::size_t pieces = 0;
  CHECK(rows_text(store, 1, pieces) == expected);
  CHECK(pieces == 2);
}
