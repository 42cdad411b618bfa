// SPDX-License-Identifier: Apache-2.0
#include "search/range_sample.hpp"

#include <twum/base/ordered.hpp>
#include <twum/optim/low_discrepancy.hpp>
#include <twum/optim/scan.hpp>

#include <algorithm>

namespace twum::inline v0_1::optim {
namespace {

// Parts of a sample that threads share; each has a stage of its own.
constexpr std::size_t kParts = 16;

struct Part {
  std::vector<RangeDesign> designs;
  Counters counters;
  StopReason stop{StopReason::finished};
};

Part evaluated(Session session, std::span<const std::vector<double>> places) {
  Part part;
  try {
    for (const auto& place : places) {
      std::vector<double> design = design_at(session.problem(), place);
      const Evaluation& evaluation = session.at(design, false);
      if (evaluation.ok()) part.designs.push_back({place, std::move(design), evaluation});
    }
  } catch (const Stop& stop) {
    part.stop = stop.reason;
  }
  part.counters = session.counters();
  return part;
}

}  // namespace

Result sample_range(const Problem& problem, const SolveOptions& options, const Deadline& deadline,
                    std::size_t count, FunctionRef<void(RangeDesign&)> see) {
  // Other seeds are those of the starts and of the first design that can be evaluated.
  const auto places = sobol_points(problem.variables.size(), count, options.seed + 2);
  const std::size_t size = (count + kParts - 1) / kParts;
  Result cost;
  cost.stages_used = size == 0 ? 0 : (count + size - 1) / size;
  run_indexed(
      {0, cost.stages_used, static_cast<unsigned>(options.jobs), {}},
      [&](std::uint64_t i) {
        const std::span all(places);
        const auto own = all.subspan(i * size, std::min(size, count - i * size));
        return evaluated(Session(problem, options, deadline, options.first_stage + i, own.size()),
                         own);
      },
      [&](std::uint64_t, std::vector<Part>& parts) {
        for (Part& part : parts) {
          cost.counters.add(part.counters);
          if (part.stop != StopReason::finished) cost.stop = part.stop;
          for (RangeDesign& design : part.designs) see(design);
        }
      });
  return cost;
}

}  // namespace twum::inline v0_1::optim
