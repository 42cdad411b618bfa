// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/options.hpp>

#include <memory>
#include <vector>

namespace twum::inline v0_1::optim {

/// Another objective for the same designs: one response or one variable, under some of the limits.
struct Question {
  enum class About : std::uint8_t { response, variable };
  About about{About::response};          ///< whether the objective is a response or a variable
  std::size_t index{0};                  ///< index of that response or variable
  Sense sense{Sense::minimize};          ///< direction of the objective
  std::vector<std::size_t> constraints;  ///< constraints that must hold; the others are left out
};

/// A problem with another objective. Not thread-safe.
struct Restated {
  Problem problem;
  /// Passes each evaluation on in the form of the original problem.
  Observer observer;
};

/// Keeps a reference to the problem. An empty observer stays empty.
Restated restate(const Problem& problem, const Question& question, const Observer& observer);

}  // namespace twum::inline v0_1::optim
