// SPDX-License-Identifier: Apache-2.0
#include <twum/base/ordered.hpp>

#include <catch2/catch.hpp>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <numeric>
#include <stdexcept>
#include <utility>
#include <vector>

using namespace twum;

namespace {

// Reads 0, 1, ... below `count`; what is written, in order.
template <typename Work>
std::vector<int> run(unsigned jobs, int count, Work work) {
  int next = 0;
  std::vector<int> written;
  run_ordered<int>(
      jobs, [&](int& item) { return (item = next++) < count; }, work,
      [&](int& item) { written.push_back(item); });
  return written;
}

void dawdle(int item) {
  volatile double sum = 0;
  for (int i = 0; i < (item % 7) * 2000; ++i) sum = sum + i;
}

}  // namespace

TEST_CASE("results come in the order of reading for any number of threads", "[core][batch]") {
  const unsigned jobs = GENERATE(1U, 2U, 3U, 8U);
  std::vector<int> expected(1000);
  std::iota(expected.begin(), expected.end(), 0);
  CHECK(run(jobs, 1000, dawdle) == expected);
  CHECK(run(jobs, 0, dawdle).empty());
}

TEST_CASE("what comes before a failure is written, and the failure comes out", "[core][batch]") {
  const unsigned jobs = GENERATE(1U, 2U, 8U);
  int next = 0;
  std::vector<int> written;
  const auto fail_at = [&](int bad_work, int bad_write, int bad_read) {
    next = 0;
    written.clear();
    const auto check = [](bool bad) {
      if (bad) throw std::runtime_error("no");
    };
    CHECK_THROWS_WITH(run_ordered<int>(
                          jobs,
                          [&](int& item) {
                            item = next++;
                            check(item == bad_read);
                            return true;
                          },
                          [&](int& item) {
                            dawdle(item);
                            check(item == bad_work);
                          },
                          [&](int& item) {
                            check(item == bad_write);
                            written.push_back(item);
                          }),
                      "no");
    std::vector<int> expected(100);
    std::iota(expected.begin(), expected.end(), 0);
    CHECK(written == expected);
  };
  fail_at(100, -1, -1);
  fail_at(-1, 100, -1);
  fail_at(-1, -1, 100);
}

TEST_CASE("nothing is read behind a failed read", "[core][batch]") {
  for (int round = 0; round < 100; ++round) {
    int next = 0;
    std::vector<int> written;
    CHECK_THROWS_WITH(run_ordered<int>(
                          8,
                          [&](int& item) {
                            item = next++;
                            if (item == 20) throw std::runtime_error("no");
                            return true;
                          },
                          [](int&) {}, [&](int& item) { written.push_back(item); }),
                      "no");
    CHECK(next == 21);
    CHECK(written.size() == 20);
  }
}

TEST_CASE(
    "items are made for every index of a range and taken in its order, on any number of threads",
    "[core][batch]") {
  const unsigned jobs = GENERATE(0U, 1U, 2U, 8U);
  const auto [first, end] = GENERATE(
      table<std::uint64_t, std::uint64_t>({{0, 1000}, {0, 1}, {7, 10}, {3, 5000}, {5, 5}, {6, 5}}));
  CAPTURE(jobs, first, end);
  std::vector<std::uint64_t> taken;
  const auto make = [](std::uint64_t i) {
    dawdle(static_cast<int>(i));
    return i * i;
  };
  const std::uint64_t next =
      run_indexed({first, end, jobs, {}}, make,
                  [&, from = first](std::uint64_t at, const std::vector<std::uint64_t>& items) {
                    CHECK(at == from + taken.size());
                    taken.insert(taken.end(), items.begin(), items.end());
                  });
  CHECK(next == std::max(first, end));
  std::vector<std::uint64_t> expected;
  for (std::uint64_t i = first; i < end; ++i) expected.push_back(i * i);
  CHECK(taken == expected);
}

TEST_CASE("a run told to end leaves no gap, and says where to go on", "[core][batch]") {
  const unsigned jobs = GENERATE(1U, 2U, 8U);
  for (int allowed : {0, 1, 100, 777}) {
    CAPTURE(jobs, allowed);
    std::atomic<int> left{allowed};
    std::vector<std::uint64_t> taken;
    const std::uint64_t next = run_indexed(
        {10, 5000, jobs, [&] { return left-- > 0; }}, [](std::uint64_t i) { return i; },
        [&](std::uint64_t, const std::vector<std::uint64_t>& items) {
          taken.insert(taken.end(), items.begin(), items.end());
        });
    CHECK(next == 10 + taken.size());
    CHECK(taken.size() <= static_cast<std::size_t>(allowed));
    for (std::size_t k = 0; k < taken.size(); ++k) CHECK(taken[k] == 10 + k);
  }
}
