// SPDX-License-Identifier: Apache-2.0
// Counts instead of times: how many published optima of the textbook problems `auto`, NLopt's SLSQP and Ipopt reach, and
// with how many evaluations (docs/optimization.md).
#include "direct_solvers.hpp"
#include "optim/bank/textbook.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <twum/optim/solve.hpp>

using namespace twum;

namespace {

bench::DirectAnswer by_auto(const optim::Problem& problem, std::size_t starts) {
  optim::SolveOptions options;
  options.starts = starts;
  options.analyse_infeasible = false;
  const optim::Result r = optim::solve(problem, options);
  return {r.design, r.counters.evaluations};
}

// Limits within 1e-6 of 1 + |limit|, and a value within 1e-6 of 1 + |published| or below.
bool reaches(const test::Textbook& book, const optim::Problem& p,
             const std::vector<double>& design) {
  if (design.empty()) return false;
  const optim::Evaluation e = p.evaluate(design, false);
  for (std::size_t i = 0; i < p.constraints.size(); ++i) {
    const optim::Constraint& c = p.constraints[i];
    const double value = e.values[1 + i];
    if (value < c.lower - 1e-6 * (1.0 + std::abs(c.lower))) return false;
    if (value > c.upper + 1e-6 * (1.0 + std::abs(c.upper))) return false;
  }
  return e.values[0] <= book.best + 1e-6 * (1.0 + std::abs(book.best));
}

void print_row(const char* name, double width,
               const std::function<bench::DirectAnswer(const optim::Problem&)>& solver) {
  std::size_t solved = 0;
  std::vector<double> evaluations;
  double sum = 0.0;
  for (const test::Textbook& book : test::textbook()) {
    const optim::Problem p = test::boxed(book, width);
    const bench::DirectAnswer answer = solver(p);
    solved += reaches(book, p, answer.design) ? 1U : 0U;
    evaluations.push_back(static_cast<double>(answer.evaluations));
    sum += evaluations.back();
  }
  std::sort(evaluations.begin(), evaluations.end());
  std::printf("| %g | %s | %zu of %zu | %.0f | %.0f |\n", width, name, solved, evaluations.size(),
              evaluations[evaluations.size() / 2], sum / static_cast<double>(evaluations.size()));
}

}  // namespace

int main() {
  std::puts("| box | solver | optima reached | evaluations, median | mean |");
  std::puts("| --- | --- | --- | --- | --- |");
  for (const double width : {10.0, 100.0, 1e4}) {
    for (const std::size_t starts : {1U, 8U})
      print_row(("`auto`, starts " + std::to_string(starts) + ", certificate included").c_str(),
                width, [&](const optim::Problem& p) { return by_auto(p, starts); });
    print_row("SLSQP called directly", width, bench::slsqp_directly);
    print_row("Ipopt called directly", width, bench::ipopt_directly);
  }
  return 0;
}
