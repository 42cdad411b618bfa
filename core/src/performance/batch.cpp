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

// answers[i] = ask(motor i), the designs shared out in blocks among `jobs` threads.
template <typename Answer, typename Ask>
std::vector<Answer> ask_all(std::span<const MotorDesign> designs, unsigned jobs, Ask ask) {
  require_admissible(designs);
  std::vector<Answer> answers(designs.size());
  std::atomic<std::size_t> next{0};
  std::exception_ptr failure;
  std::mutex guard;
  const auto work = [&] {
    try {
      for (std::size_t from; (from = next.fetch_add(kBlock)) < designs.size();) {
        const std::size_t to = std::min(from + kBlock, designs.size());
        for (std::size_t i = from; i < to; ++i) answers[i] = ask(Motor(designs[i]));
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
  try {
    for (std::size_t i = 1; i < std::min(wanted, blocks); ++i) helpers.emplace_back(work);
  } catch (const std::exception&) {
    // No more threads or memory to be had: the threads that are there do the work.
  }
  work();
  for (std::thread& helper : helpers) helper.join();
  if (failure) std::rethrow_exception(failure);
  return answers;
}

}  // namespace

std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs) {
  return ask_all<std::vector<MetricValue>>(
      designs, jobs, [&](const Motor& motor) { return evaluate(motor, requests); });
}

std::vector<std::vector<MetricDerivative>> differentiate_designs(
    std::span<const MotorDesign> designs, std::span<const MetricRequest> requests,
    bool fixed_static_friction, unsigned jobs) {
  return ask_all<std::vector<MetricDerivative>>(designs, jobs, [&](const Motor& motor) {
    return differentiate(motor, requests, fixed_static_friction);
  });
}

}  // namespace twum
