// SPDX-License-Identifier: Apache-2.0
// What `twum verify` calls a difference, on rows and summaries made for it.
#include "entries_support.hpp"
#include "results/answers.hpp"
#include "run/verify_checks.hpp"
#include "support/constants.hpp"

#include <catch2/catch.hpp>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;
using Catch::Matchers::Contains;
using Catch::Matchers::StartsWith;

namespace {

StoredRow row_of(std::uint64_t stage, std::uint64_t index, std::vector<double> values,
                 const std::string& status = "ok") {
  return {stage, index, std::move(values), status, {}};
}

// What verify_rows() says of one stored row and what becomes of it now.
Verification compared(const StoredRow& there, const StoredRow& now) {
  ScriptedKind kind;
  kind.again = [&](const StoredRow&) { return now; };
  ResultStore store(":memory:", kind.all);
  store.add(there);
  Verification found;
  verify_rows(kind, store, {}, found);
  return found;
}

// Of the elastic layer at 100 N, whose stall torque is mu F_N r = 0.2 * 100 N * 0.0265 m.
constexpr double kTorque = 0.2 * 100 * 0.0265;

struct Question {
  ScratchFolder folder;
  StudyFile file{study_in(folder, "{kind: curve, points: 3}")};
  ScriptedKind kind;

  Verification designs(const std::string& summary) const {
    Verification found;
    verify_designs(file, kind, Json::parse(summary), {}, found);
    return found;
  }
};

std::string design(const std::string& preload, const std::string& torque,
                   const std::string& more = "") {
  return R"({"design": {"preload": )" + preload + R"(}, "metrics": {"stall_torque": )" + torque +
         "}" + more + "}";
}

}  // namespace

TEST_CASE("numbers hold up to a relative 1e-12, and the largest deviation is noted",
          "[studies][verify]") {
  Verification found;
  CHECK(note_deviation(found, 3.0, 3.0));
  CHECK(note_deviation(found, kNaN, kNaN));
  CHECK(found.deviation == 0);
  // 2 + 4e-13 is off by 4e-13 / (2 + 4e-13): rounding of the sum is 2^-52, a thousandth of that.
  CHECK(note_deviation(found, 2.0, 2.0 + 4e-13));
  CHECK(found.deviation == Approx(2e-13).epsilon(2e-3));
  CHECK(note_deviation(found, -1.0, -1.0 - 1e-13));  // a smaller one
  CHECK(found.deviation == Approx(2e-13).epsilon(2e-3));
  CHECK_FALSE(note_deviation(found, 1.0, 1.0 + 3e-12));
  CHECK_FALSE(note_deviation(found, 1.0, kNaN));
  CHECK_FALSE(note_deviation(found, kNaN, 0.0));
  CHECK_FALSE(note_deviation(found, 0.0, 1e-300));
  CHECK(found.failed == 0);  // to complain is the caller's
}

TEST_CASE("a row that has changed is named with both values", "[studies][verify]") {
  const StoredRow there = row_of(0, 7, {100, 0.53});
  CHECK(compared(there, there).holds());
  CHECK(compared(there, there).rows_checked == 1);
  const Verification other = compared(there, row_of(0, 7, {100, 0.54}));
  CHECK(other.complaints ==
        std::vector<std::string>{"row 7: stall_torque is 0.53 there, 0.54 now"});
  const Verification none = compared(row_of(3, 7, {100, kNaN}), row_of(3, 7, {100, 0.5}));
  CHECK(none.complaints ==
        std::vector<std::string>{"row 7 of stage 3: stall_torque is no value there, 0.5 now"});
  const Verification gone = compared(row_of(0, 0, {100, 0.5}), row_of(0, 0, {100, kNaN}));
  CHECK(gone.complaints ==
        std::vector<std::string>{"row 0: stall_torque is 0.5 there, no value now"});
  // Both columns differ: one line for a row.
  CHECK(compared(there, row_of(0, 7, {90, 0.54})).failed == 1);
}

TEST_CASE("a row with another status is named with both, whatever its values are",
          "[studies][verify]") {
  const Verification found =
      compared(row_of(0, 2, {100, 0.53}), row_of(0, 2, {100, 0.54}, "stall_torque: resonance"));
  CHECK(found.failed == 1);
  CHECK(found.complaints ==
        std::vector<std::string>{"row 2: status 'ok' there, 'stall_torque: resonance' now"});
}

TEST_CASE("a row that cannot be computed by itself is counted as skipped", "[studies][verify]") {
  ScriptedKind kind;
  kind.again = [](const StoredRow& row) {
    return row.index % 2 == 0 ? std::optional<StoredRow>(row) : std::nullopt;
  };
  ResultStore store(":memory:", kind.all);
  for (std::uint64_t i = 0; i < 9; ++i) store.add(row_of(0, i, {1, 2}));
  Verification found;
  verify_rows(kind, store, {}, found);
  CHECK(found.rows == 9);
  CHECK(found.rows_checked == 5);
  CHECK(found.rows_skipped == 4);
  CHECK(found.holds());
}

TEST_CASE("as many rows are drawn as asked for, and twenty complaints are kept",
          "[studies][verify]") {
  ScriptedKind kind;
  kind.again = [](const StoredRow& row) {
    StoredRow other = row;
    other.values[1] += 1;
    return other;
  };
  ResultStore store(":memory:", kind.all);
  for (std::uint64_t i = 0; i < 60; ++i) store.add(row_of(0, i, {1, 2}));
  VerifyOptions options;
  options.samples = GENERATE(std::uint64_t{0}, std::uint64_t{1}, std::uint64_t{25},
                             std::uint64_t{60}, std::uint64_t{1000});
  Verification found;
  verify_rows(kind, store, options, found);
  const std::uint64_t drawn = std::min<std::uint64_t>(options.samples, 60);
  CHECK(found.rows_checked == drawn);
  CHECK(found.failed == drawn);
  CHECK(found.complaints.size() == std::min<std::uint64_t>(drawn, 20));
}

TEST_CASE("designs are looked for wherever they stand in a summary", "[studies][verify]") {
  const Question question;
  const std::string good = design("100", number_json(kTorque).dump());
  // mu F_N r, up to some roundings of the solution; far below the 1e-12 that holds.
  CHECK(question.designs(R"({"best": )" + good + "}").holds());
  const Verification found = question.designs(R"({"front": [)" + good + ", " +
                                              design("100", "0.6") + R"(], "word": "x"})");
  CHECK(found.designs == 2);
  REQUIRE(found.failed == 1);
  CHECK_THAT(found.complaints[0],
             StartsWith("summary.json: front[1].metrics.stall_torque is 0.6 there, 0.5"));
}

TEST_CASE("a missing number in a summary is missing in the new computation too",
          "[studies][verify]") {
  const Question question;
  const Verification found = question.designs(design("100", "null"));
  REQUIRE(found.failed == 1);
  CHECK_THAT(found.complaints[0], Contains("stall_torque is null there, 0.5"));
}

TEST_CASE("an invalid design and an unknown metric are named with their place",
          "[studies][verify]") {
  const Question question;
  const auto complaint = [&](const std::string& text) {
    const Verification found = question.designs(R"({"best": )" + text + "}");
    REQUIRE(found.failed == 1);
    return found.complaints[0];
  };
  CHECK(complaint(R"({"design": {"colour": 3}, "metrics": {}})") ==
        "summary.json: best: 'colour' is not a parameter");
  CHECK_THAT(complaint(design("-1", "0.5")), StartsWith("summary.json: best: preload "));
  CHECK_THAT(complaint(design(R"("much")", "0.5")), StartsWith("summary.json: best: preload "));
  CHECK_THAT(complaint(R"({"design": {}, "metrics": {"stall_torqe": 1}})"),
             Contains("did you mean 'stall_torque'"));
}

TEST_CASE("the members of a family are checked at their own value", "[studies][verify]") {
  const Question question;
  const auto curves = [](const std::string& first, const std::string& second) {
    return R"({"family": {"parameter": "preload"}, "curves": [{"preload": 100, "metrics": )" +
           first + R"(}, {"preload": 200)" + second + "}]}";
  };
  const std::string one = R"({"stall_torque": )" + number_json(kTorque).dump() + "}";
  const std::string two =
      R"(, "metrics": {"stall_torque": )" + number_json(2 * kTorque).dump() + "}";
  CHECK(question.designs(curves(one, two)).designs == 2);
  CHECK(question.designs(curves(one, two)).holds());
  CHECK(question.designs(curves(one, "")).holds());  // without metrics nothing is claimed
  CHECK(question.designs(curves(R"({"stall_torque": 1})", two)).failed == 1);
  // A member without its value cannot be made, and a motor alone needs none.
  CHECK(question.designs(R"({"family": {"parameter": "preload"}, "curves": [{"metrics": {}}]})")
            .failed == 1);
  const double alone = 0.2 * 160 * 0.0265;  // the motor as it is has 160 N
  CHECK(question
            .designs(R"({"curves": [{"metrics": {"stall_torque": )" + number_json(alone).dump() +
                     "}}]}")
            .holds());
}

TEST_CASE("a claimed certificate is computed again", "[studies][verify]") {
  Question question;
  const std::string torque = number_json(kTorque).dump();
  const auto with_certificate = [&](const std::string& certificate) {
    return question.designs(R"({"best": )" +
                            design("100", torque, R"(, "certificate": )" + certificate) + "}");
  };
  optim::Certificate now;
  std::vector<double> asked;
  question.kind.evidence = [&](std::span<const double> variables) {
    asked.assign(variables.begin(), variables.end());
    return now;
  };
  now.passed = true;
  CHECK(with_certificate(R"({"passed": true})").certificates == 1);
  CHECK(asked == std::vector<double>{100});
  CHECK(with_certificate(R"({"passed": false})").certificates == 0);
  CHECK(with_certificate("null").certificates == 0);

  now.passed = false;
  now.reason = "not stationary";
  const Verification found = with_certificate(R"({"passed": true})");
  CHECK(found.complaints ==
        std::vector<std::string>{"summary.json: best: certified there, but now: not stationary"});

  // With several goals a front may be concave: only stationarity is claimed then.
  now.reason = "stationary, but not a minimum";
  now.weights = {0.5, 0.5};
  CHECK(with_certificate(R"({"passed": true})").holds());
  now.reason = "not stationary";
  CHECK_FALSE(with_certificate(R"({"passed": true})").holds());
  now.reason = "stationary, but not a minimum";
  now.weights = {1};
  CHECK_FALSE(with_certificate(R"({"passed": true})").holds());

  // A kind without optima, and a design without a value of the variable: nothing to measure.
  question.kind.evidence = [](std::span<const double>) { return std::nullopt; };
  CHECK(with_certificate(R"({"passed": true})").certificates == 0);
  CHECK(question
            .designs(R"({"best": {"design": {}, "metrics": {}, "certificate": {"passed": true}}})")
            .certificates == 0);
}

TEST_CASE("the answer that follows from the rows is compared entry by entry", "[studies][verify]") {
  ScriptedKind kind;
  SweepResult answer;
  answer.sampling = "grid";
  answer.designs = answer.stored = 2;
  answer.variables = {{"preload", "N"}};
  answer.metrics = {
      {{"stall_torque", "N.m"}, 2, 0.5, 0.5, 1.0, {0, {95}, {0.5}}, {1, {190}, {1.0}}}};
  kind.answer = [&](RunContext&) { return KindAnswer{"done", answer}; };
  ResultStore store(":memory:", kind.all);
  const auto complaints = [&](const std::function<void(Json&)>& change) {
    Json summary = answer_json(answer);
    summary["outcome"] = "done";
    summary["seconds"] = 3.5;  // more than the answer is no contradiction
    change(summary);
    Verification found;
    CHECK(verify_answer(kind, store, summary, {}, found).outcome == "done");
    CHECK(found.answer_checked);
    return found.complaints;
  };
  using Lines = std::vector<std::string>;
  CHECK(complaints([](Json&) {}).empty());
  CHECK(complaints([](Json& s) { s["stored"] = 3; }) ==
        Lines{"summary.json: stored is 3 there, but follows from the rows as 2"});
  CHECK(complaints([](Json& s) { s["sampling"] = "list"; }) ==
        Lines{R"(summary.json: sampling is "list" there, but follows from the rows as "grid")"});
  CHECK(
      complaints([](Json& s) { s["metrics"]["stall_torque"]["max"] = "1"; }) ==
      Lines{
          R"(summary.json: metrics.stall_torque.max is "1" there, but follows from the rows as 1.0)"});
  CHECK(
      complaints([](Json& s) { s["metrics"]["stall_torque"].erase("min"); }) ==
      Lines{
          R"x(summary.json: metrics.stall_torque.min is "(missing)" there, but follows from the rows as 0.5)x"});
  CHECK(complaints([](Json& s) { s["units"] = 1; }).size() == 1);
  CHECK(complaints([](Json& s) { s["stored"] = Json::object(); }).size() == 1);
  CHECK(complaints([](Json& s) { s["outcome"] = "failed"; }) ==
        Lines{"summary.json: outcome is 'failed' there, but follows from the rows as 'done'"});
  CHECK(complaints([](Json& s) { s.erase("outcome"); }) ==
        Lines{"summary.json: outcome is '' there, but follows from the rows as 'done'"});
}

TEST_CASE("lists of an answer are compared item by item, and by their length",
          "[studies][verify]") {
  ScriptedKind kind;
  CurveResult answer;
  answer.members = {{kNaN, {{"stall_torque", "N.m", 0.5}}, {"ok"}, 3, 0, 10},
                    {kNaN, {{"stall_torque", "N.m", 0.7}}, {"ok"}, 3, 0, 10}};
  kind.answer = [&](RunContext&) { return KindAnswer{"done", answer}; };
  ResultStore store(":memory:", kind.all);
  Json summary = answer_json(answer);
  summary["outcome"] = "done";
  const auto complaints = [&] {
    Verification found;
    verify_answer(kind, store, summary, {}, found);
    return found.complaints;
  };
  CHECK(complaints().empty());
  REQUIRE(summary["curves"].size() == 2);
  summary["curves"][1]["metrics"]["stall_torque"] = 0.8;
  REQUIRE(complaints().size() == 1);
  CHECK_THAT(complaints()[0], Contains("curves[1].metrics.stall_torque is 0.8 there"));
  summary["curves"].erase(1);
  REQUIRE(complaints().size() == 1);
  CHECK_THAT(complaints()[0], StartsWith("summary.json: curves is [{"));
  summary["curves"] = 2;
  CHECK_THAT(complaints().at(0), StartsWith("summary.json: curves is 2 there"));
  summary["curves"] = Json::array();
  REQUIRE(complaints().size() == 1);
  CHECK_THAT(complaints()[0], StartsWith("summary.json: curves is [] there"));
}

TEST_CASE("rows that the study asks for and the database has not are counted",
          "[studies][verify]") {
  ScriptedKind kind;
  kind.answer = [](RunContext& context) {
    for (std::uint64_t i = 0; i < 5; ++i) context.store.add({0, i, {1, 2}});
    return KindAnswer{"done", SweepResult{}};
  };
  ResultStore store(":memory:", kind.all);
  store.add({0, 0, {1, 2}});
  store.add({0, 3, {1, 2}});
  Json summary = answer_json(SweepResult{});
  summary["outcome"] = "done";
  Verification found;
  verify_answer(kind, store, summary, {}, found);
  CHECK(found.complaints ==
        std::vector<std::string>{"results.db: 3 rows of the study are missing"});
}
