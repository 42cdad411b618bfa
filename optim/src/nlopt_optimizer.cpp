// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>

#include "nlopt_table.hpp"
#include "optimizer.hpp"

#include <algorithm>
#include <cmath>
#include <exception>
#include <memory>

namespace twum::optim {
namespace {

struct OptDeleter {
  void operator()(nlopt_opt o) const { nlopt_destroy(o); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

// Tolerances in the unit box. NLopt decides when to stop; whether that was right is decided by the
// certificate, so they are tight and a run is bounded by its calls.
constexpr double kXtol = 1e-11;
constexpr double kFtol = 1e-14;
constexpr double kConstraintTolerance = 1e-9;
constexpr int kMostRestarts = 60;  // after failed evaluations, each in a smaller or a shifted box

// One side of one row, as NLopt wants it: sign * (c - limit) <= 0, or = 0.
struct OneSide {
  std::size_t row;
  double sign;
  double limit;
};

// What the callbacks share. They never throw: a C library is in between.
struct Bridge {
  Nlp* nlp{nullptr};
  nlopt_opt opt{nullptr};
  bool gradient{false};
  bool rank_failures{false};
  std::size_t calls_left{0};
  std::vector<OneSide> inequalities;
  std::vector<OneSide> equalities;
  std::exception_ptr error;
  std::vector<double> failed_at;
  StopReason stop{StopReason::finished};
  bool out_of_calls{false};
  std::vector<double> last;

  bool halted() const {
    return error || !failed_at.empty() || stop != StopReason::finished || out_of_calls;
  }
};

const NlpValue* request(Bridge& b, unsigned n, const double* z) {
  if (b.halted()) return nullptr;
  const std::span<const double> point(z, n);
  try {
    if (!std::equal(point.begin(), point.end(), b.last.begin(), b.last.end())) {
      if (b.calls_left == 0) {
        b.out_of_calls = true;
        nlopt_force_stop(b.opt);
        return nullptr;
      }
      --b.calls_left;
      b.last.assign(point.begin(), point.end());
    }
    const NlpValue* value = b.nlp->at(point, b.gradient);
    if (value == nullptr && !b.rank_failures) b.failed_at.assign(point.begin(), point.end());
    if (value != nullptr || b.rank_failures) return value;
  } catch (const Stop& s) {
    b.stop = s.reason;
  } catch (...) {
    b.error = std::current_exception();
  }
  nlopt_force_stop(b.opt);
  return nullptr;
}

// Returned when there is no value: an infinity ranks a failed design behind all others where a
// method only compares, and is not looked at where the run has been stopped.
constexpr double kNoValue = HUGE_VAL;

double objective(unsigned n, const double* z, double* gradient, void* data) {
  auto& b = *static_cast<Bridge*>(data);
  const NlpValue* v = request(b, n, z);
  if (gradient != nullptr) std::fill_n(gradient, n, 0.0);
  if (v == nullptr) return kNoValue;
  if (gradient != nullptr) std::copy(v->df.begin(), v->df.end(), gradient);
  return v->f;
}

void sides(Bridge& b, const std::vector<OneSide>& list, double* result, unsigned n, const double* z,
           double* gradient) {
  const NlpValue* v = request(b, n, z);
  for (std::size_t i = 0; i < list.size(); ++i) {
    const OneSide& s = list[i];
    result[i] = v == nullptr ? kNoValue : s.sign * (v->c[s.row] - s.limit);
    if (gradient == nullptr) continue;
    for (std::size_t k = 0; k < n; ++k)
      gradient[i * n + k] = v == nullptr ? 0.0 : s.sign * v->dc[s.row * n + k];
  }
}

void inequalities(unsigned, double* result, unsigned n, const double* z, double* gradient,
                  void* data) {
  auto& b = *static_cast<Bridge*>(data);
  sides(b, b.inequalities, result, n, z, gradient);
}

void equalities(unsigned, double* result, unsigned n, const double* z, double* gradient,
                void* data) {
  auto& b = *static_cast<Bridge*>(data);
  sides(b, b.equalities, result, n, z, gradient);
}

void split_rows(Bridge& b) {
  for (std::size_t i = 0; i < b.nlp->rows(); ++i) {
    const Row& row = b.nlp->row(i);
    if (b.nlp->equality(i)) {
      b.equalities.push_back({i, 1.0, row.lower});
      continue;
    }
    if (std::isfinite(row.upper)) b.inequalities.push_back({i, 1.0, row.upper});
    if (std::isfinite(row.lower)) b.inequalities.push_back({i, -1.0, row.lower});
  }
}

void set_tolerances(nlopt_opt opt, const RunSettings& settings) {
  nlopt_set_xtol_rel(opt, number_option(settings, "xtol_rel", kXtol, 0.0, 1.0));
  nlopt_set_xtol_abs1(opt, 1e-13);
  nlopt_set_ftol_rel(opt, number_option(settings, "ftol_rel", kFtol, 0.0, 1.0));
}

Opt make(nlopt_algorithm id, std::size_t n, const RunSettings& settings) {
  Opt opt(nlopt_create(id, static_cast<unsigned>(n)));
  if (!opt) throw InputError("NLopt cannot create this algorithm");
  set_tolerances(opt.get(), settings);
  return opt;
}

// The algorithm itself, or an augmented Lagrangian around it where it lacks what the rows need.
// AUGLAG and MLSL crash without a subsidiary, so they always get one with its own limits.
Opt build(const NloptAlgorithm& a, const Bridge& b, const RunSettings& settings) {
  const std::size_t n = b.nlp->size();
  const int inner_calls =
      whole_option(settings, "inner_evaluations", 200.0 + 100.0 * static_cast<double>(n), 1.0, 1e9);
  const auto with_subsidiary = [&](nlopt_algorithm outer, Opt inner, double tolerance) {
    nlopt_set_maxeval(inner.get(), inner_calls);
    if (tolerance > 0.0) nlopt_set_xtol_rel(inner.get(), tolerance);
    Opt opt = make(outer, n, settings);
    nlopt_set_local_optimizer(opt.get(), inner.get());
    return opt;
  };
  Opt own = make(a.id, n, settings);
  if (a.subsidiary != NLOPT_NUM_ALGORITHMS) {
    // Thousands of local searches only have to tell basins apart.
    own = with_subsidiary(a.id, make(a.subsidiary, n, settings), a.global ? 1e-6 : 0.0);
    if (a.global) nlopt_set_ftol_rel(own.get(), 0.0);
  }
  if (!b.inequalities.empty() && !a.inequality)
    return with_subsidiary(a.gradient ? NLOPT_LD_AUGLAG : NLOPT_LN_AUGLAG, std::move(own), 0.0);
  if (!b.equalities.empty() && !a.equality)
    return with_subsidiary(a.gradient ? NLOPT_LD_AUGLAG_EQ : NLOPT_LN_AUGLAG_EQ, std::move(own),
                           0.0);
  return own;
}

void add_rows(nlopt_opt opt, Bridge& b, const RunSettings& settings) {
  const double tolerance =
      number_option(settings, "constraint_tolerance", kConstraintTolerance, 0.0, 1.0);
  const std::vector<double> t(std::max(b.inequalities.size(), b.equalities.size()), tolerance);
  if (!b.inequalities.empty())
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(b.inequalities.size()),
                                     inequalities, &b, t.data());
  if (!b.equalities.empty())
    nlopt_add_equality_mconstraint(opt, static_cast<unsigned>(b.equalities.size()), equalities, &b,
                                   t.data());
}

void apply_options(nlopt_opt opt, const RunSettings& settings) {
  const int population = whole_option(settings, "population", 0.0, 0.0, 1e6);
  if (population > 0) nlopt_set_population(opt, static_cast<unsigned>(population));
  const int storage = whole_option(settings, "vector_storage", 0.0, 0.0, 1e4);
  if (storage > 0) nlopt_set_vector_storage(opt, static_cast<unsigned>(storage));
  const double step = number_option(settings, "initial_step", 0.0, 0.0, 1.0);
  if (step > 0.0) nlopt_set_initial_step1(opt, step);
}

const char* word_of(nlopt_result code) {
  const char* word = nlopt_result_to_string(code);
  return word != nullptr ? word : "unknown";
}

// One call of nlopt_optimize. ROUNDOFF_LIMITED and the like are no errors: the archive has the
// best point, and the certificate judges it.
RunReport run_once(const NloptAlgorithm& a, Bridge& b, std::vector<double> z,
                   const RunSettings& settings) {
  Opt opt = build(a, b, settings);
  b.opt = opt.get();
  nlopt_set_lower_bounds(opt.get(), b.nlp->lower().data());
  nlopt_set_upper_bounds(opt.get(), b.nlp->upper().data());
  nlopt_set_min_objective(opt.get(), objective, &b);
  add_rows(opt.get(), b, settings);
  apply_options(opt.get(), settings);
  for (std::size_t k = 0; k < z.size(); ++k)
    z[k] = std::clamp(z[k], b.nlp->lower()[k], b.nlp->upper()[k]);
  double f = 0.0;
  const nlopt_result code = nlopt_optimize(opt.get(), z.data(), &f);
  RunReport report{b.out_of_calls ? "MAXEVAL_REACHED" : word_of(code), static_cast<int>(code),
                   b.stop, std::move(z)};
  if (code == NLOPT_INVALID_ARGS)
    report.word +=
        std::string(": ") + (nlopt_get_errmsg(opt.get()) ? nlopt_get_errmsg(opt.get()) : "");
  b.opt = nullptr;
  return report;
}

double distance(std::span<const double> a, std::span<const double> b) {
  double d = 0.0;
  for (std::size_t k = 0; k < a.size(); ++k) d = std::max(d, std::abs(a[k] - b[k]));
  return d;
}

bool box_holds_back(const Nlp& nlp, std::span<const double> z, double radius) {
  if (radius <= 0.0) return false;
  for (std::size_t k = 0; k < nlp.units(); ++k) {
    const bool low = z[k] - nlp.lower()[k] < 1e-3 * radius && nlp.lower()[k] > 0.0;
    const bool high = nlp.upper()[k] - z[k] < 1e-3 * radius && nlp.upper()[k] < 1.0;
    if (low || high) return true;
  }
  return false;
}

// NLopt has no way to be told that a design cannot be evaluated. So the run is stopped and begun
// again from the best design, in a box that leaves the failed one out; once such a run ends at the
// wall of its box, the box grows again.
class Restarts {
 public:
  Restarts(Nlp& nlp, std::span<const double> start)
      : nlp_(nlp), from_(start.begin(), start.end()) {}

  /// The next start, or nothing when there is no use in another run.
  bool next(Bridge& b, const RunReport& report) {
    if (b.error || b.stop != StopReason::finished || b.out_of_calls || ++count_ > kMostRestarts)
      return false;
    if (nlp_.best()) from_ = nlp_.best()->z;
    if (!b.failed_at.empty()) return shrink(b);
    if (!box_holds_back(nlp_, report.z, radius_)) return false;
    radius_ *= 4.0;
    if (radius_ >= 1.0) radius_ = 0.0;
    nlp_.restrict_box(from_, radius_);
    return true;
  }
  const std::vector<double>& from() const { return from_; }

 private:
  bool shrink(Bridge& b) {
    const std::span<const double> failed(b.failed_at.data(), nlp_.units());
    if (!nlp_.best()) {
      nudge(failed);
    } else {
      const double d = distance(failed, std::span<const double>(from_).first(nlp_.units()));
      // The best design itself lacks a derivative: begin beside it.
      if (d == 0.0) nudge(failed);
      radius_ = d > 0.0 ? 0.5 * d : 0.25 * (radius_ > 0.0 ? radius_ : 1.0);
      if (radius_ < 1e-10) return false;
    }
    b.failed_at.clear();
    nlp_.restrict_box(from_, radius_);
    return true;
  }

  // A small move towards the middle of the box, longer each time.
  void nudge(std::span<const double> failed) {
    ++nudges_;
    const double part = std::min(0.5, 1e-4 * std::pow(4.0, nudges_));
    for (std::size_t k = 0; k < nlp_.units(); ++k)
      from_[k] =
          failed[k] + part * ((k + static_cast<std::size_t>(nudges_)) % 2 == 0 ? 0.45 - failed[k]
                                                                               : 0.55 - failed[k]);
  }

  Nlp& nlp_;
  std::vector<double> from_;
  double radius_{0.0};
  int count_{0};
  int nudges_{0};
};

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
  nlopt_srand(static_cast<unsigned long>(settings.seed));  // its generator belongs to the thread
  Bridge bridge;
  bridge.nlp = &nlp;
  bridge.gradient = a.gradient;
  bridge.rank_failures = a.compares_only;
  bridge.calls_left = settings.max_calls;
  split_rows(bridge);
  Restarts restarts(nlp, start);
  RunReport report;
  do {
    bridge.last.clear();
    report = run_once(a, bridge, restarts.from(), settings);
  } while (restarts.next(bridge, report));
  nlp.restrict_box(start, 0.0);
  if (bridge.error) std::rethrow_exception(bridge.error);
  if (!bridge.failed_at.empty()) report.word = "EVALUATION_FAILED";
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
      {"nlopt", "xtol_rel", "number", "0 to 1",
       "relative change of the variables at which to stop"},
      {"nlopt", "ftol_rel", "number", "0 to 1",
       "relative change of the objective at which to stop"},
      {"nlopt", "constraint_tolerance", "number", "0 to 1", "scaled violation that counts as none"},
      {"nlopt", "population", "integer", "0 to 1e6",
       "size of the population; 0: the algorithm's own"},
      {"nlopt", "vector_storage", "integer", "0 to 1e4",
       "gradients that lbfgs and var keep; 0: its own"},
      {"nlopt", "initial_step", "number", "0 to 1", "first step in the unit box; 0: its own"},
      {"nlopt", "inner_evaluations", "integer", "1 to 1e9",
       "limit of each subsidiary search of auglag and mlsl"}};
}

}  // namespace twum::optim
