// SPDX-License-Identifier: Apache-2.0
#include "solvers/nlopt_job.hpp"

#include <twum/base/error.hpp>

#include <memory>

namespace twum::inline v0_1::optim {
namespace {

struct OptDeleter {
  void operator()(nlopt_opt o) const { nlopt_destroy(o); }
};
using Opt = std::unique_ptr<std::remove_pointer_t<nlopt_opt>, OptDeleter>;

constexpr double kXtolAbsolute = 1e-13;  // in the unit box

struct Call {
  NloptRequests& requests;
  nlopt_opt opt;

  void stop_if_halted() const {
    if (requests.halted()) nlopt_force_stop(opt);
  }
};

double objective(unsigned n, const double* z, double* gradient, void* data) {
  const auto& call = *static_cast<const Call*>(data);
  const double value = call.requests.objective({z, n}, gradient);
  call.stop_if_halted();
  return value;
}

template <NloptRequests::Rows rows>
void limits(unsigned m, double* result, unsigned n, const double* z, double* jacobian, void* data) {
  const auto& call = *static_cast<const Call*>(data);
  call.requests.limits(rows, {z, n}, {result, m}, jacobian);
  call.stop_if_halted();
}

Opt create(nlopt_algorithm id, const NloptJob& job) {
  Opt opt(nlopt_create(id, static_cast<unsigned>(job.start.size())));
  if (!opt) throw InputError("NLopt cannot create this algorithm");
  nlopt_set_xtol_rel(opt.get(), job.xtol_rel);
  nlopt_set_xtol_abs1(opt.get(), kXtolAbsolute);
  nlopt_set_ftol_rel(opt.get(), job.ftol_rel);
  return opt;
}

// Of MLSL, which crashes without one.
void add_subsidiary(nlopt_opt opt, const NloptJob& job) {
  const Opt local = create(job.subsidiary, job);
  nlopt_set_maxeval(local.get(), job.inner_calls);
  nlopt_set_xtol_rel(local.get(), 1e-6);  // thousands of searches only have to distinguish basins
  nlopt_set_local_optimizer(opt, local.get());
  nlopt_set_ftol_rel(opt, 0.0);
}

void set_options(nlopt_opt opt, const NloptJob& job) {
  nlopt_set_lower_bounds(opt, job.lower.data());
  nlopt_set_upper_bounds(opt, job.upper.data());
  nlopt_set_maxeval(opt, job.calls);
  if (job.subsidiary != NLOPT_NUM_ALGORITHMS) add_subsidiary(opt, job);
  if (job.population > 0) nlopt_set_population(opt, static_cast<unsigned>(job.population));
  if (job.vector_storage > 0)
    nlopt_set_vector_storage(opt, static_cast<unsigned>(job.vector_storage));
  if (!job.steps.empty()) nlopt_set_initial_step(opt, job.steps.data());
}

void set_functions(nlopt_opt opt, const NloptJob& job, Call& call) {
  using Rows = NloptRequests::Rows;
  nlopt_set_min_objective(opt, objective, &call);
  if (!job.inequalities.empty())
    nlopt_add_inequality_mconstraint(opt, static_cast<unsigned>(job.inequalities.size()),
                                     limits<Rows::inequalities>, &call, job.inequalities.data());
  if (!job.equalities.empty())
    nlopt_add_equality_mconstraint(opt, static_cast<unsigned>(job.equalities.size()),
                                   limits<Rows::equalities>, &call, job.equalities.data());
}

}  // namespace

NloptEnd run_job(const NloptJob& job, NloptRequests& requests) {
  if (job.seed) nlopt_srand(static_cast<unsigned long>(*job.seed));
  const Opt opt = create(job.id, job);
  Call call{requests, opt.get()};
  set_options(opt.get(), job);
  set_functions(opt.get(), job, call);
  NloptEnd end;
  end.z = job.start;
  double f = 0.0;
  end.code = nlopt_optimize(opt.get(), end.z.data(), &f);
  const char* error = nlopt_get_errmsg(opt.get());
  if (end.code == NLOPT_INVALID_ARGS && error != nullptr) end.error = error;
  return end;
}

}  // namespace twum::inline v0_1::optim
