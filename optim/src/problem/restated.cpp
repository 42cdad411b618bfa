// SPDX-License-Identifier: Apache-2.0
#include "problem/restated.hpp"

namespace twum::inline v0_1::optim {
namespace {

// The answer to a question, row by row, from the answer of the original problem.
class Answer {
 public:
  Answer(const Evaluation& whole, std::size_t variables) : whole_(whole), variables_(variables) {}

  void add_response(std::size_t response) {
    const std::size_t row = picked_.values.size();
    picked_.values.push_back(whole_.values[response]);
    for (KinkedEntry kink : whole_.kinks) {
      if (kink.response != response) continue;
      kink.response = row;
      picked_.kinks.push_back(kink);
    }
    if (whole_.jacobian.empty()) return;
    const auto begin = whole_.jacobian.begin() + static_cast<std::ptrdiff_t>(response * variables_);
    picked_.jacobian.insert(picked_.jacobian.end(), begin,
                            begin + static_cast<std::ptrdiff_t>(variables_));
  }

  void add_variable(std::size_t variable, std::span<const double> design) {
    picked_.values.push_back(design[variable]);
    if (whole_.jacobian.empty()) return;
    for (std::size_t j = 0; j < variables_; ++j)
      picked_.jacobian.push_back(j == variable ? 1.0 : 0.0);
  }

  Evaluation take() { return std::move(picked_); }

 private:
  const Evaluation& whole_;
  std::size_t variables_;
  Evaluation picked_;
};

}  // namespace

Restated restate(const Problem& problem, const Question& question, const Observer& observer) {
  Restated result;
  Problem& p = result.problem;
  p.variables = problem.variables;
  p.objectives = {{"asked", question.sense}};
  for (const std::size_t i : question.constraints) p.constraints.push_back(problem.constraints[i]);
  const auto last = std::make_shared<Evaluation>();
  p.evaluate = [&problem, question, last](std::span<const double> design, bool gradient) {
    *last = problem.evaluate(design, gradient);
    if (!last->ok()) return *last;
    Answer answer(*last, problem.variables.size());
    if (question.about == Question::About::variable)
      answer.add_variable(question.index, design);
    else
      answer.add_response(question.index);
    for (const std::size_t i : question.constraints)
      answer.add_response(problem.objectives.size() + i);
    return answer.take();
  };
  if (observer)
    result.observer = [observer, last](const Observation& o) {
      const Evaluation& seen = o.evaluation.ok() ? *last : o.evaluation;
      observer({o.stage, o.index, o.design, o.gradient, seen});
    };
  return result;
}

}  // namespace twum::inline v0_1::optim
