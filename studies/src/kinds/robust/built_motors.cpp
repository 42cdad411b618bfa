// SPDX-License-Identifier: Apache-2.0
#include "kinds/robust/built_motors.hpp"

#include "kinds/rows/row_bytes.hpp"
#include "kinds/rows/search_rows.hpp"
#include "kinds/rows/search_stage.hpp"

#include <utility>

namespace twum::inline v0_1::studies {
namespace {

constexpr std::uint64_t kBuilt = SearchStage{SearchStage::Phase::built}.number();
constexpr std::uint64_t kAllResponses = ~std::uint64_t{0};

StoredRow row_asking(const BuiltQuestion& of, std::span<const double> built,
                     std::optional<std::size_t> only, bool gradient) {
  StoredRow asked;
  asked.stage = kBuilt;
  asked.values = of.design;
  append_bytes(asked.detail, static_cast<std::uint8_t>(of.motor_before));
  append_bytes(asked.detail, static_cast<std::uint8_t>(gradient));
  append_bytes(asked.detail, only ? static_cast<std::uint64_t>(*only) : kAllResponses);
  append_numbers(asked.detail, {built.begin(), built.end()});
  return asked;
}

}  // namespace

bool is_of_built_motor(const StoredRow& asked) { return asked.stage == kBuilt; }

optim::RobustProblem shared_robust_problem(const RobustQuestion& question, BuiltQuestion of,
                                           Executor& executor) {
  optim::RobustProblem problem = robust_problem(question);
  problem.built = [of = std::move(of), &executor](std::span<const double> built,
                                                  std::optional<std::size_t> only, bool gradient) {
    return evaluation_of(executor.row(row_asking(of, built, only, gradient)));
  };
  return problem;
}

BuiltMotorRows::Problem BuiltMotorRows::problem(const BuiltQuestion& of) const {
  const std::lock_guard lock(mutex_);
  Problem& known = problems_[of];
  if (!known) known = std::make_shared<const optim::RobustProblem>(robust_problem(question_(of)));
  return known;
}

StoredRow BuiltMotorRows::answer(const StoredRow& asked) const {
  RowBytes bytes(asked.detail);
  const BuiltQuestion of{asked.values, bytes.take<std::uint8_t>() != 0};
  const bool gradient = bytes.take<std::uint8_t>() != 0;
  const auto only = bytes.take<std::uint64_t>();
  const std::vector<double> built = bytes.numbers();
  const optim::Evaluation evaluation = problem(of)->built(
      built, only == kAllResponses ? std::nullopt : std::optional<std::size_t>(only), gradient);
  StoredRow row;
  row.stage = kBuilt;
  if (!evaluation.ok()) row.status = evaluation.failure;
  row.detail = evaluation_bytes(evaluation, built.size(), gradient);
  return row;
}

}  // namespace twum::inline v0_1::studies
