// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include "solvers/allowance.hpp"
#include "solvers/augmented_lagrangian.hpp"
#include "solvers/nlopt_job.hpp"
#include "solvers/nlopt_table.hpp"
#include "solvers/restarts.hpp"
#include "solvers/solver_process.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

namespace twum::inline v0_1::optim {
namespace {

// Tolerances in the unit box. They are tight, because the certificate decides whether a point is optimal, and the
// number of calls limits a run.
constexpr double kXtol = 1e-11;
constexpr double kFtol = 1e-14;
constexpr double kConstraintTolerance = 1e-9;
// A search ends if the objective no longer changes. Without this, NLopt's algorithms by Luksan loop forever in a
// corner of the box without a request.
constexpr double kLeastFtol = 1e-16;

// A step between two requests takes some n^3 operations at most, each far below a microsecond, and with few
// variables microseconds in all. In seconds of computing.
double longest_step(std::size_t n) { return std::max(1.0, 1e-6 * std::pow(n, 3)); }

// Returned if there is no value. In methods that only compare, infinity ranks a failed design behind all others;
// otherwise the run has been stopped and the value is ignored.
constexpr double kRejected = HUGE_VAL;

// Answers NLopt's requests from the problem. Nothing is thrown through the C library.
class Bridge : public NloptRequests {
 public:
  Bridge(Nlp& problem, const NloptAlgorithm& a, const RunSettings& settings)
      : nlp(problem),
        gradient(a.gradient),
        rank_failures(a.compares_only),
        allowance(nlp, settings.max_calls,
                  a.gradient && !a.global ? Allowance::Search::local : Allowance::Search::global),
        seed(settings.seed) {
    if (may_turn_for_ever(a))
      process.emplace(solver_process(), longest_step(nlp.size()),
                      [this] { return due() != StopReason::finished; });
  }

  Nlp& nlp;
  bool gradient;
  bool rank_failures;
  Allowance allowance;
  std::vector<OneSide> inequalities;  // NLopt's own
  std::vector<OneSide> equalities;
  AugmentedLagrangian lagrangian{{}, 0.0};  // of all others
  std::exception_ptr error;
  std::vector<double> failed_at;
  StopReason stop{StopReason::finished};

  bool over() const { return error || stop != StopReason::finished || allowance.used_up(); }
  bool halted() const override { return over() || !failed_at.empty(); }

  // Runs NLopt. Nothing if it looped and was ended.
  std::optional<NloptEnd> run(NloptJob job) {
    job.seed = std::exchange(seed, {});
    auto end = process ? process->run(job, *this) : run_job(job, *this);
    if (!end) {
      if (stop == StopReason::finished) stop = due();
      if (stop == StopReason::finished) allowance.stall();
    }
    return end;
  }

  const NlpValue* value_at(std::span<const double> point) {
    if (halted()) return nullptr;
    try {
      if (allowance.take(point)) {
        const NlpValue* value = nlp.at(point, gradient);
        if (value == nullptr && !rank_failures) failed_at.assign(point.begin(), point.end());
        return value;
      }
    } catch (const Stop& s) {
      stop = s.reason;
    } catch (...) {
      error = std::current_exception();
    }
    return nullptr;
  }

  double objective(std::span<const double> z, double* slopes) override {
    const NlpValue* v = value_at(z);
    if (slopes != nullptr) std::fill_n(slopes, z.size(), 0.0);
    if (v == nullptr) return kRejected;
    const double value = lagrangian.value(*v);
    const std::vector<double> slope =
        slopes != nullptr ? lagrangian.gradient(*v) : std::vector<double>{};
    if (!can_be_reckoned_with(value) || !std::ranges::all_of(slope, can_be_reckoned_with)) {
      if (!rank_failures) failed_at.assign(z.begin(), z.end());
      return kRejected;
    }
    std::ranges::copy(slope, slopes);
    return value;
  }

  void limits(Rows rows, std::span<const double> z, std::span<double> result,
              double* jacobian) override {
    const std::vector<OneSide>& list = rows == Rows::inequalities ? inequalities : equalities;
    const NlpValue* v = value_at(z);
    for (std::size_t i = 0; i < list.size(); ++i) {
      const OneSide& s = list[i];
      result[i] = v == nullptr ? kRejected : s.of(*v);
      if (jacobian == nullptr) continue;
      for (std::size_t k = 0; k < z.size(); ++k)
        jacobian[i * z.size() + k] = v == nullptr ? 0.0 : s.sign * v->dc[s.row * z.size() + k];
    }
  }

 private:
  // Why the search has to end, also while the solver computes.
  StopReason due() const {
    try {
      nlp.session().heed();
      return StopReason::finished;
    } catch (const Stop& s) {
      return s.reason;
    }
  }

  std::optional<std::uint64_t> seed;     // until a job has taken it
  std::optional<SolverProcess> process;  // in which NLopt runs if it may loop forever
};

double constraint_tolerance(const RunSettings& settings) {
  return number_option(settings, "constraint_tolerance", kConstraintTolerance, 0.0, 1.0);
}

// Rows that the algorithm supports are passed to it; the others go into the Lagrangian.
void split_rows(Bridge& b, const NloptAlgorithm& a, const RunSettings& settings) {
  std::vector<OneSide> others;
  std::vector<OneSide>& inequalities = a.inequality ? b.inequalities : others;
  for (std::size_t i = 0; i < b.nlp.rows(); ++i) {
    const LinearForm& row = b.nlp.row(i);
    if (b.nlp.equality(i)) {
      (a.equality ? b.equalities : others).push_back({i, 1.0, row.lower, true});
      continue;
    }
    if (std::isfinite(row.upper)) inequalities.push_back({i, 1.0, row.upper});
    if (std::isfinite(row.lower)) inequalities.push_back({i, -1.0, row.lower});
  }
  b.lagrangian = AugmentedLagrangian(std::move(others), constraint_tolerance(settings));
}

int inner_calls(const RunSettings& settings, std::size_t n) {
  return whole_option(settings, "inner_evaluations", 200.0 + 100.0 * static_cast<double>(n), 1.0,
                      1e9);
}

// NLopt counts points outside of the bounds too, which praxis tries and no callback sees. Several for each allowed
// point are enough.
int most_calls(const Bridge& b) {
  constexpr std::size_t kMost = 1000000000;
  return static_cast<int>(1000 + 4 * std::min(b.allowance.points(), kMost / 4));
}

// No looser than a tenth of what the limit tolerates: a steep start makes scaled values small.
std::vector<double> tolerances(const Bridge& b, const std::vector<OneSide>& list,
                               const RunSettings& settings) {
  constexpr double kLeast = 1e-11;
  std::vector<double> all;
  for (const OneSide& side : list)
    all.push_back(std::min(std::max(0.1 * b.nlp.tolerance(side.row), kLeast),
                           constraint_tolerance(settings)));
  return all;
}

std::vector<double> first_steps(const Nlp& nlp, const RunSettings& settings) {
  const double step = number_option(settings, "initial_step", 0.0, 0.0, 1.0);
  if (!(step > 0.0)) return {};
  std::vector<double> steps(nlp.size(), step);
  for (std::size_t k = 0; k < nlp.units(); ++k) steps[k] *= nlp.most()[k] - nlp.least()[k];
  return steps;
}

NloptJob job_from(const NloptAlgorithm& a, const Bridge& b, std::vector<double> z,
                  const RunSettings& settings) {
  NloptJob job;
  job.id = a.id;
  job.subsidiary = a.subsidiary;
  job.lower = b.nlp.lower();
  job.upper = b.nlp.upper();
  for (std::size_t k = 0; k < z.size(); ++k) z[k] = std::clamp(z[k], job.lower[k], job.upper[k]);
  job.start = std::move(z);
  job.inequalities = tolerances(b, b.inequalities, settings);
  job.equalities = tolerances(b, b.equalities, settings);
  job.xtol_rel = number_option(settings, "xtol_rel", kXtol, 0.0, 1.0);
  job.ftol_rel = std::max(number_option(settings, "ftol_rel", kFtol, 0.0, 1.0), kLeastFtol);
  job.inner_calls = inner_calls(settings, b.nlp.size());
  job.calls = b.lagrangian.empty() ? most_calls(b) : std::min(job.inner_calls, most_calls(b));
  job.population = whole_option(settings, "population", 0.0, 0.0, 1e6);
  job.vector_storage = whole_option(settings, "vector_storage", 0.0, 0.0, 1e4);
  job.steps = first_steps(b.nlp, settings);
  return job;
}

const char* word_of(nlopt_result code) {
  const char* word = nlopt_result_to_string(code);
  return word != nullptr ? word : "unknown";
}

// One call of nlopt_optimize. ROUNDOFF_LIMITED and the like are no errors: the archive has the
// best point, and the certificate judges it.
RunReport search(const NloptAlgorithm& a, Bridge& b, std::vector<double> z,
                 const RunSettings& settings) {
  const NloptEnd end = b.run(job_from(a, b, std::move(z), settings)).value_or(NloptEnd{});
  RunReport report{b.allowance.used_up() ? b.allowance.word() : word_of(end.code),
                   static_cast<int>(end.code), b.stop, end.z};
  if (!end.error.empty()) report.word += ": " + end.error;
  return report;
}

RunReport run_once(const NloptAlgorithm& a, Bridge& b, std::vector<double> z,
                   const RunSettings& settings) {
  if (b.lagrangian.empty()) return search(a, b, std::move(z), settings);
  InnerSearch inner;
  inner.minimize = [&](std::vector<double> from) {
    return search(a, b, std::move(from), settings);
  };
  inner.look = [&](std::span<const double> at) { return b.value_at(at); };
  inner.halted = [&] { return b.halted(); };
  return minimize(b.lagrangian, inner, std::move(z));
}

const NloptAlgorithm& algorithm(const std::string& solver) {
  const auto& table = nlopt_algorithms();
  const auto it = std::find_if(table.begin(), table.end(), [&](const auto& a) {
    return solver == std::string("nlopt:") + a.name;
  });
  TWUM_ASSERT(it != table.end());
  return *it;
}

RunReport run_nlopt(const SolverInfo& info, Nlp& nlp, std::span<const double> start,
                    const RunSettings& settings) {
  require_known_options(settings, nlopt_options());
  const NloptAlgorithm& a = algorithm(info.name);
  Bridge bridge(nlp, a, settings);
  split_rows(bridge, a, settings);
  Restarts restarts(nlp, start);
  RunReport report;
  bool again = true;
  while (again) {
    bridge.allowance.forget_last();
    report = run_once(a, bridge, restarts.from(), settings);
    again = !bridge.over() && restarts.next(bridge.failed_at, report.z);
    if (again) bridge.failed_at.clear();
  }
  report.stop = bridge.stop;
  nlp.restrict_box(start, 0.0);
  if (bridge.error) std::rethrow_exception(bridge.error);
  if (!bridge.failed_at.empty() && !bridge.over()) report.word = "EVALUATION_FAILED";
  return report;
}

}  // namespace

std::vector<Optimizer> nlopt_optimizers() {
  std::vector<Optimizer> list;
  for (const NloptAlgorithm& a : nlopt_algorithms()) {
    SolverInfo info;
    info.name = std::string("nlopt:") + a.name;
    info.available = a.refusal[0] == '\0';
    info.description = info.available ? a.description : a.refusal;
    info.gradient = a.gradient;
    info.inequality = true;  // its own, or by an augmented Lagrangian
    info.equality = true;
    info.global = a.global;
    info.stochastic = a.stochastic;
    info.augmented = !a.inequality;
    info.own_process = may_turn_for_ever(a);
    info.on_failure = a.compares_only ? FailurePolicy::rank_last : FailurePolicy::restart;
    list.push_back({std::move(info), run_nlopt});
  }
  return list;
}

std::vector<SolverOption> nlopt_options() {
  return {
      {"nlopt", "xtol_rel", "number", "relative change of the variables at which to stop", 0, 1},
      {"nlopt", "ftol_rel", "number", "relative change of the objective at which to stop", 0, 1},
      {"nlopt", "constraint_tolerance", "number", "largest scaled violation that counts as zero", 0,
       1},
      {"nlopt", "population", "integer", "size of the population; 0: the algorithm's own", 0, 1e6},
      {"nlopt", "vector_storage", "integer",
       "gradients that lbfgs and var keep; 0: the algorithm's own", 0, 1e4},
      {"nlopt", "initial_step", "number",
       "first step in parts of the range; 0: the algorithm's own", 0, 1},
      {"nlopt", "inner_evaluations", "integer",
       "limit of each search within an augmented Lagrangian or mlsl", 1, 1e9}};
}

}  // namespace twum::inline v0_1::optim
