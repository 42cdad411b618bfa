// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/jobs/ordered.hpp>

#include <catch2/catch.hpp>

#include <numeric>
#include <stdexcept>

using namespace twum::studies;

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

TEST_CASE("results come in the order of reading for any number of threads", "[studies][run]") {
  const unsigned jobs = GENERATE(1U, 2U, 3U, 8U);
  std::vector<int> expected(1000);
  std::iota(expected.begin(), expected.end(), 0);
  CHECK(run(jobs, 1000, dawdle) == expected);
  CHECK(run(jobs, 0, dawdle).empty());
}

TEST_CASE("what comes before a failure is written, and the failure comes out", "[studies][run]") {
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

TEST_CASE("nothing is read behind a failed read", "[studies][run]") {
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
