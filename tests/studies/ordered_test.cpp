// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/run/ordered.hpp>

#include <catch2/catch.hpp>

#include <cstdlib>
#include <new>
#include <numeric>
#include <stdexcept>

using namespace twum::studies;

// Memory that a test can refuse to its own thread.
static thread_local bool no_memory = false;

void* operator new(std::size_t size) {
  void* place = no_memory ? nullptr : std::malloc(size > 0 ? size : 1);
  if (place == nullptr) throw std::bad_alloc();
  return place;
}
void operator delete(void* place) noexcept { std::free(place); }
void operator delete(void* place, std::size_t /*size*/) noexcept { std::free(place); }

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

TEST_CASE("without memory for threads the caller's does the work", "[studies][run]") {
  int next = 0;
  int sum = 0;
  const auto read = [&](int& item) {
    no_memory = false;  // what follows needs some
    return (item = next++) < 10;
  };
  bool refused = false;
  no_memory = true;
  try {
    run_ordered<int>(4, read, dawdle, [&](int& item) { sum += item; });
  } catch (const std::bad_alloc&) {
    refused = true;
  }
  no_memory = false;
  CHECK_FALSE(refused);
  CHECK(sum == 45);
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
