// SPDX-License-Identifier: Apache-2.0
#include <twum/core/performance/batch.hpp>

#include <twum/base/error.hpp>

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <string>
#include <thread>

namespace twum {
namespace {

constexpr std::size_t kBlock = 64;  // designs a thread takes at a time

void require_admissible(std::span<const MotorDesign> designs) {
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const std::vector<std::string> wrong = complaints(designs[i]);
    if (!wrong.empty()) throw InputError("design " + std::to_string(i) + ": " + wrong.front());
  }
}

}  // namespace

std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs) {
  require_admissible(designs);
  std::vector<std::vector<MetricValue>> rows(designs.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t from; (from = next.fetch_add(kBlock)) < designs.size();) {
        const std::size_t to = std::min(from + kBlock, designs.size());
        for (std::size_t i = from; i < to; ++i) rows[i] = evaluate(Motor(designs[i]), requests);
      }
    } catch (...) {
      const std::lock_guard lock(guard);
      failure = std::current_exception();
      next = designs.size();
    }
  };
  const std::size_t blocks = (designs.size() + kBlock - 1) / kBlock;
  const std::size_t wanted = jobs > 0 ? jobs : std::max(1U, std::thread::hardware_concurrency());
  std::vector<std::thread> helpers;
  for (std::size_t i = 1; i < std::min(wanted, blocks); ++i) helpers.emplace_back(work);
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
  return rows;
}

}  // namespace twum
