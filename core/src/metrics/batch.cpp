// SPDX-License-Identifier: Apache-2.0
#include <twum/core/batch.hpp>

#include <algorithm>
#include <iterator>

namespace twum::inline v0_1 {
namespace {

void require_admissible(std::span<const MotorDesign> designs) {
  for (std::size_t i = 0; i < designs.size(); ++i) {
    const std::vector<std::string> wrong = complaints(designs[i]);
    if (!wrong.empty()) throw InputError("design " + std::to_string(i) + ": " + wrong.front());
  }
}

// The answers of designs that have been found to be admissible. What goes wrong nevertheless comes out.
template <typename Ask>
auto ask_all(std::span<const MotorDesign> designs, unsigned jobs,
             const std::function<bool()>& proceed, Ask ask) {
  require_admissible(designs);
  std::vector<std::invoke_result_t<Ask&, const Motor&>> answers;
  answers.reserve(designs.size());
  run_indexed(
      {0, designs.size(), jobs, proceed}, [&](std::uint64_t i) { return ask(Motor(designs[i])); },
      [&](std::uint64_t, auto& block) { std::ranges::move(block, std::back_inserter(answers)); });
  return answers;
}

}  // namespace

std::vector<std::vector<MetricValue>> evaluate_designs(std::span<const MotorDesign> designs,
                                                       std::span<const MetricRequest> requests,
                                                       unsigned jobs,
                                                       const std::function<bool()>& proceed) {
  return ask_all(designs, jobs, proceed,
                 [&](const Motor& motor) { return evaluate(motor, requests); });
}

std::vector<std::vector<MetricDerivative>> differentiate_designs(
    std::span<const MotorDesign> designs, std::span<const MetricRequest> requests,
    bool fixed_static_friction, unsigned jobs, const std::function<bool()>& proceed) {
  return ask_all(designs, jobs, proceed, [&](const Motor& motor) {
    return differentiate(motor, requests, fixed_static_friction);
  });
}

}  // namespace twum::inline v0_1
