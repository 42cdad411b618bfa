// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/optim/options.hpp>

#include <memory>
#include <vector>

namespace twum::optim {

/// What is asked of the same designs instead: one response or one variable, under some of the limits.
struct Question {
  enum class About : std::uint8_t { response, variable };
  About about{About::response};          ///< whose value is the objective
  std::size_t index{0};                  ///< of that response or variable
  Sense sense{Sense::minimize};          ///< what is wanted of it
  std::vector<std::size_t> constraints;  ///< the limits that must hold, others are left out
};

/// A problem asked another question. It evaluates in one thread at a time.
struct Restated {
  Problem problem;
  /// Passes each evaluation on as the original problem would answer it.
  Observer observer;
};

/// Keeps a reference to the problem. An empty observer stays empty.
Restated restate(const Problem& problem, const Question& question, const Observer& observer);

}  // namespace twum::optim
