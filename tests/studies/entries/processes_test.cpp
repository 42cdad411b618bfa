// SPDX-License-Identifier: Apache-2.0
// What processes say to each other.
#include "entries_support.hpp"
#include "run/row_message.hpp"
#include "run/shared_executor.hpp"

#include <twum/studies/processes.hpp>

#include <catch2/catch.hpp>

#include <bit>
#include <cstdint>
#include <limits>

using namespace twum;
using namespace twum::studies;
using namespace twum::test;

namespace {

std::vector<std::uint64_t> bits(const std::vector<double>& values) {
  std::vector<std::uint64_t> list;
  for (const double value : values) list.push_back(std::bit_cast<std::uint64_t>(value));
  return list;
}

}  // namespace

TEST_CASE("rows arrive to the bit", "[studies][processes]") {
  using Limits = std::numeric_limits<double>;
  const std::vector<StoredRow> sent{
      {0, 0, {}, "ok", {}},
      {~0ULL,
       7,
       {0.1, -0.0, Limits::quiet_NaN(), -Limits::quiet_NaN(), Limits::denorm_min()},
       "ok",
       {}},
      {3,
       ~0ULL,
       {Limits::infinity()},
       "stall_torque: no-periodic-state",
       std::string("a\0b\xff", 4)}};
  const std::vector<StoredRow> there = rows_of(row_message(sent));
  REQUIRE(there.size() == sent.size());
  for (std::size_t i = 0; i < sent.size(); ++i) {
    CHECK(there[i].stage == sent[i].stage);
    CHECK(there[i].index == sent[i].index);
    CHECK(bits(there[i].values) == bits(sent[i].values));
    CHECK(there[i].status == sent[i].status);
    CHECK(there[i].detail == sent[i].detail);
  }
  CHECK(rows_of(row_message({})).empty());
}

TEST_CASE("a message that was cut short is no rows", "[studies][processes]") {
  const std::vector<StoredRow> sent{{1, 2, {0.5, 1.5}, "a reason", "bytes"}};
  const std::string message = row_message(sent);
  for (std::size_t size = 0; size < message.size(); ++size)
    CHECK_THROWS_AS(rows_of(message.substr(0, size)), StoreError);
}

TEST_CASE("an answer holds the rows in the order asked, or why there are none",
          "[studies][processes]") {
  ScriptedKind kind;
  kind.again = [](const StoredRow& asked) -> std::optional<StoredRow> {
    if (asked.index == 13) throw std::runtime_error("no such number");
    StoredRow row = asked;
    row.values = {static_cast<double>(asked.index), 0.5};
    return row;
  };
  ThreadExecutor executor(kind);
  const std::string good = answer_of(
      row_message(std::vector<StoredRow>{{0, 5, {}, "ok", {}}, {0, 2, {}, "ok", {}}}), executor);
  CHECK(good.front() == 'r');
  const std::vector<StoredRow> rows = rows_of(good.substr(1));
  REQUIRE(rows.size() == 2);
  CHECK(rows[0].values == std::vector<double>{5, 0.5});
  CHECK(rows[1].values == std::vector<double>{2, 0.5});
  CHECK(answer_of(row_message(std::vector<StoredRow>{{0, 13, {}, "ok", {}}}), executor) ==
        "eno such number");
}

TEST_CASE("an executor of threads ends where it is told to", "[studies][processes]") {
  ScriptedKind kind;
  kind.again = [](const StoredRow& asked) { return std::optional<StoredRow>(asked); };
  ThreadExecutor executor(kind, 3);
  CHECK(executor.lanes() == 3);
  std::vector<StoredRow> asked(10);
  for (std::size_t i = 0; i < asked.size(); ++i) asked[i].index = i;
  int left = 4;
  const std::vector<StoredRow> made = executor.rows(asked, [&] { return left-- > 0; });
  REQUIRE(made.size() == 4);
  for (std::size_t i = 0; i < made.size(); ++i) CHECK(made[i].index == i);
}
