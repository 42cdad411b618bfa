// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include "solvers/allowance.hpp"
#include "solvers/augmented_lagrangian.hpp"
#include "solvers/nlopt_table.hpp"
#include "solvers/restarts.hpp"
#include "solvers/solver_thread.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>
#include <optional>

namespace twum::optim {
namespace {

struct OptDeleter {
  void operator()(nlopt_opt o) const { nlopt_destroy(o); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

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

// Data of the callbacks, which must not throw through the C library.
struct Bridge {
  Bridge(Nlp& problem, const NloptAlgorithm& a, std::size_t calls)
      : nlp(problem), gradient(a.gradient), rank_failures(a.compares_only), allowance(nlp, calls) {
    if (may_turn_for_ever(a))
      thread.emplace(longest_step(nlp.size()), [this] { return due() != StopReason::finished; });
  }

  Nlp& nlp;
  nlopt_opt opt{nullptr};
  bool gradient;
  bool rank_failures;
  Allowance allowance;
  std::vector<OneSide> inequalities;  // NLopt's own
  std::vector<OneSide> equalities;
  AugmentedLagrangian lagrangian{{}, 0.0};  // of all others
  std::exception_ptr error;
  std::vector<double> failed_at;
  StopReason stop{StopReason::finished};
  std::optional<SolverThread> thread;  // runs NLopt's code if it may loop forever

  bool over() const { return error || stop != StopReason::finished || allowance.used_up(); }
  bool halted() const { return over() || !failed_at.empty(); }

  // Why the search has to end, also while the solver computes.
  StopReason due() const {
    try {
      nlp.session().heed();
      return StopReason::finished;
    } catch (const Stop& s) {
      return s.reason;
    }
  }

  // Runs NLopt's code. False if it looped and was ended.
  bool run(const std::function<void()>& library) {
    if (thread) return thread->run(library);
    library();
    return true;
  }

  // Called from NLopt's code; the request is executed by the caller's thread.
  template <class Request>
  void serve(const Request& request) {
    if (thread)
      thread->ask(request);
    else
      request();
  }
};

const NlpValue* request(Bridge& b, std::span<const double> point) {
  if (b.halted()) return nullptr;
  try {
    if (b.allowance.take(point)) {
      const NlpValue* value = b.nlp.at(point, b.gradient);
      if (value != nullptr || b.rank_failures) return value;
      b.failed_at.assign(point.begin(), point.end());
    }
  } catch (const Stop& s) {
    b.stop = s.reason;
  } catch (...) {
    b.error = std::current_exception();
  }
  if (b.opt != nullptr) nlopt_force_stop(b.opt);
  return nullptr;
}

// Returned if there is no value. In methods that only compare, infinity ranks a failed design behind all others;
// otherwise the run has been stopped and the value is ignored.
constexpr double kRejected = HUGE_VAL;

double lagrangian(Bridge& b, unsigned n, const double* z, double* gradient) {
  const NlpValue* v = request(b, {z, n});
  if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
  if (v == nullptr) return kRejected;
  const double value = b.lagrangian.value(*v);
  const std::vector<double> slope =
      gradient != nullptr ? b.lagrangian.gradient(*v) : std::vector<double>{};
  if (!can_be_reckoned_with(value) || !std::ranges::all_of(slope, can_be_reckoned_with)) {
    if (b.rank_failures) return kRejected;
    b.failed_at.assign(z, z + n);
    nlopt_force_stop(b.opt);
    return kRejected;
  }
  std::ranges::copy(slope, gradient);
  return value;
}

void sides(Bridge& b, const std::vector<OneSide>& list, double* result, unsigned n, const double* z,
           double* gradient) {
  const NlpValue* v = request(b, {z, n});
  for (std::size_t i = 0; i < list.size(); ++i) {
    const OneSide& s = list[i];
    result[i] = v == nullptr ? kRejected : s.of(*v);
    if (gradient == nullptr) continue;
    for (std::size_t k = 0; k < n; ++k)
      gradient[i * n + k] = v == nullptr ? 0.0 : s.sign * v->dc[s.row * n + k];
  }
}

double objective(unsigned n, const double* z, double* gradient, void* data) {
  auto& b = *static_cast<Bridge*>(data);
  double value = kRejected;
  b.serve([&] { value = lagrangian(b, n, z, gradient); });
  return value;
}

void inequalities(unsigned, double* result, unsigned n, const double* z, double* gradient,
                  void* data) {
  auto& b = *static_cast<Bridge*>(data);
  b.serve([&] { sides(b, b.inequalities, result, n, z, gradient); });
}

void equalities(unsigned, double* result, unsigned n, const double* z, double* gradient,
                void* data) {
  auto& b = *static_cast<Bridge*>(data);
  b.serve([&] { sides(b, b.equalities, result, n, z, gradient); });
}

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

void set_tolerances(nlopt_opt opt, const RunSettings& settings) {
  nlopt_set_xtol_rel(opt, number_option(settings, "xtol_rel", kXtol, 0.0, 1.0));
  nlopt_set_xtol_abs1(opt, 1e-13);
  nlopt_set_ftol_rel(opt,
                     std::max(number_option(settings, "ftol_rel", kFtol, 0.0, 1.0), kLeastFtol));
}

Opt make(nlopt_algorithm id, std::size_t n, const RunSettings& settings) {
  Opt opt(nlopt_create(id, static_cast<unsigned>(n)));
  if (!opt) throw InputError("NLopt cannot create this algorithm");
  set_tolerances(opt.get(), settings);
  return opt;
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

// MLSL crashes without a subsidiary.
Opt build(const NloptAlgorithm& a, const Bridge& b, const RunSettings& settings) {
  const std::size_t n = b.nlp.size();
  Opt own = make(a.id, n, settings);
  const int inner = inner_calls(settings, n);
  nlopt_set_maxeval(own.get(),
                    b.lagrangian.empty() ? most_calls(b) : std::min(inner, most_calls(b)));
  if (a.subsidiary == NLOPT_NUM_ALGORITHMS) return own;
  const Opt local = make(a.subsidiary, n, settings);
  nlopt_set_maxeval(local.get(), inner);
  nlopt_set_xtol_rel(local.get(), 1e-6);  // thousands of searches only have to distinguish basins
  nlopt_set_local_optimizer(own.get(), local.get());
  nlopt_set_ftol_rel(own.get(), 0.0);
  return own;
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

void add_rows(nlopt_opt opt, Bridge& b, const RunSettings& settings) {
  if (!b.inequalities.empty())
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(b.inequalities.size()),
                                     inequalities, &b,
                                     tolerances(b, b.inequalities, settings).data());
  if (!b.equalities.empty())
    nlopt_add_equality_mconstraint(opt, static_cast<unsigned>(b.equalities.size()), equalities, &b,
                                   tolerances(b, b.equalities, settings).data());
}

void apply_options(nlopt_opt opt, const Nlp& nlp, const RunSettings& settings) {
  const int population = whole_option(settings, "population", 0.0, 0.0, 1e6);
  if (population > 0) nlopt_set_population(opt, static_cast<unsigned>(population));
  const int storage = whole_option(settings, "vector_storage", 0.0, 0.0, 1e4);
  if (storage > 0) nlopt_set_vector_storage(opt, static_cast<unsigned>(storage));
  const double step = number_option(settings, "initial_step", 0.0, 0.0, 1.0);
  if (!(step > 0.0)) return;
  std::vector<double> steps(nlp.size(), step);
  for (std::size_t k = 0; k < nlp.units(); ++k) steps[k] *= nlp.most()[k] - nlp.least()[k];
  nlopt_set_initial_step(opt, steps.data());
}

const char* word_of(nlopt_result code) {
  const char* word = nlopt_result_to_string(code);
  return word != nullptr ? word : "unknown";
}

// One call of nlopt_optimize. ROUNDOFF_LIMITED and the like are no errors: the archive has the
// best point, and the certificate judges it.
RunReport search(const NloptAlgorithm& a, Bridge& b, std::vector<double> z,
                 const RunSettings& settings) {
  Opt opt = build(a, b, settings);
  b.opt = opt.get();
  nlopt_set_lower_bounds(opt.get(), b.nlp.lower().data());
  nlopt_set_upper_bounds(opt.get(), b.nlp.upper().data());
  nlopt_set_min_objective(opt.get(), objective, &b);
  add_rows(opt.get(), b, settings);
  apply_options(opt.get(), b.nlp, settings);
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = std::clamp(z[k], b.nlp.lower()[k], b.nlp.upper()[k]);
  double f = 0.0;
  nlopt_result code = NLOPT_FORCED_STOP;
  const bool back = b.run([&] { code = nlopt_optimize(opt.get(), z.data(), &f); });
  if (!back) {
    z.clear();  // half written
    if (b.stop == StopReason::finished) b.stop = b.due();
    if (b.stop == StopReason::finished) b.allowance.stall();
  }
  RunReport report{b.allowance.used_up() ? b.allowance.word() : word_of(code),
                   static_cast<int>(code), b.stop, std::move(z)};
  if (code == NLOPT_INVALID_ARGS)
    report.word +=
        std::string(": ") + (nlopt_get_errmsg(opt.get()) ? nlopt_get_errmsg(opt.get()) : "");
  b.opt = nullptr;
  return report;
}

RunReport run_once(const NloptAlgorithm& a, Bridge& b, std::vector<double> z,
                   const RunSettings& settings) {
  if (b.lagrangian.empty()) return search(a, b, std::move(z), settings);
  InnerSearch inner;
  inner.minimize = [&](std::vector<double> from) {
    return search(a, b, std::move(from), settings);
  };
  inner.look = [&](std::span<const double> at) { return request(b, at); };
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
  Bridge bridge(nlp, a, settings.max_calls);
  bridge.run([&] { nlopt_srand(static_cast<unsigned long>(settings.seed)); });  // of the thread
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

}  // namespace twum::optim
