// SPDX-License-Identifier: Apache-2.0
#include "direct_solvers.hpp"

#include <nlopt.h>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpTNLP.hpp>

#include <algorithm>
#include <cmath>

namespace twum::bench {
namespace {

using optim::Evaluation;
using optim::Problem;

// Evaluates a problem of one minimized objective, and counts distinct designs.
class Counted {
 public:
  explicit Counted(const Problem& problem) : problem_(problem) {}

  const Evaluation& at(const double* x) {
    const std::vector<double> design(x, x + problem_.variables.size());
    if (design == last_) return evaluation_;
    last_ = design;
    ++count_;
    evaluation_ = problem_.evaluate(design, true);
    return evaluation_;
  }
  const Problem& problem() const { return problem_; }
  std::size_t count() const { return count_; }

 private:
  const Problem& problem_;
  std::vector<double> last_;
  Evaluation evaluation_;
  std::size_t count_{0};
};

double objective(unsigned n, const double* x, double* gradient, void* data) {
  const Evaluation& e = static_cast<Counted*>(data)->at(x);
  if (gradient != nullptr) std::copy_n(e.jacobian.begin(), n, gradient);
  return e.values[0];
}

struct Side {
  Counted* counted;
  std::size_t row;
  double sign;
  double limit;
};

double side(unsigned n, const double* x, double* gradient, void* data) {
  const auto& s = *static_cast<Side*>(data);
  const Evaluation& e = s.counted->at(x);
  for (unsigned j = 0; gradient != nullptr && j < n; ++j)
    gradient[j] = s.sign * e.jacobian[s.row * n + j];
  return s.sign * (e.values[s.row] - s.limit);
}

class Tnlp : public Ipopt::TNLP {
 public:
  explicit Tnlp(Counted& counted) : counted_(counted), p_(counted.problem()) {}

  bool get_nlp_info(Ipopt::Index& n, Ipopt::Index& m, Ipopt::Index& jacobian, Ipopt::Index& hessian,
                    IndexStyleEnum& style) override {
    n = static_cast<Ipopt::Index>(p_.variables.size());
    m = static_cast<Ipopt::Index>(p_.constraints.size());
    jacobian = n * m;
    hessian = 0;
    style = C_STYLE;
    return true;
  }
  bool get_bounds_info(Ipopt::Index, double* lower, double* upper, Ipopt::Index, double* below,
                       double* above) override {
    for (std::size_t j = 0; j < p_.variables.size(); ++j) {
      lower[j] = p_.variables[j].lower;
      upper[j] = p_.variables[j].upper;
    }
    for (std::size_t i = 0; i < p_.constraints.size(); ++i) {
      below[i] = std::max(p_.constraints[i].lower, -2e19);
      above[i] = std::min(p_.constraints[i].upper, 2e19);
    }
    return true;
  }
  bool get_starting_point(Ipopt::Index, bool, double* x, bool, double*, double*, Ipopt::Index, bool,
                          double*) override {
    const auto start = optim::start_design(p_);
    std::copy(start.begin(), start.end(), x);
    return true;
  }
  bool eval_f(Ipopt::Index, const double* x, bool, double& value) override {
    value = counted_.at(x).values[0];
    return std::isfinite(value);
  }
  bool eval_grad_f(Ipopt::Index n, const double* x, bool, double* gradient) override {
    std::copy_n(counted_.at(x).jacobian.begin(), n, gradient);
    return true;
  }
  bool eval_g(Ipopt::Index, const double* x, bool, Ipopt::Index m, double* rows) override {
    std::copy_n(counted_.at(x).values.begin() + 1, m, rows);
    return std::all_of(rows, rows + m, [](double v) { return std::isfinite(v); });
  }
  bool eval_jac_g(Ipopt::Index n, const double* x, bool, Ipopt::Index m, Ipopt::Index,
                  Ipopt::Index* row, Ipopt::Index* column, double* values) override {
    for (Ipopt::Index k = 0; values == nullptr && k < n * m; ++k) {
      row[k] = k / n;
      column[k] = k % n;
    }
    if (values != nullptr) std::copy_n(counted_.at(x).jacobian.begin() + n, n * m, values);
    return true;
  }
  void finalize_solution(Ipopt::SolverReturn, Ipopt::Index n, const double* x, const double*,
                         const double*, Ipopt::Index, const double*, const double*, double,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    answer.assign(x, x + n);
  }
  std::vector<double> answer;

 private:
  Counted& counted_;
  const Problem& p_;
};

}  // namespace

DirectAnswer slsqp_directly(const Problem& problem) {
  Counted counted(problem);
  const auto n = static_cast<unsigned>(problem.variables.size());
  nlopt_opt opt = nlopt_create(NLOPT_LD_SLSQP, n);
  std::vector<double> lower, upper;
  for (const auto& v : problem.variables) {
    lower.push_back(v.lower);
    upper.push_back(v.upper);
  }
  nlopt_set_lower_bounds(opt, lower.data());
  nlopt_set_upper_bounds(opt, upper.data());
  nlopt_set_min_objective(opt, objective, &counted);
  std::vector<Side> sides;
  sides.reserve(2 * problem.constraints.size());
  for (std::size_t i = 0; i < problem.constraints.size(); ++i) {
    const optim::Constraint& c = problem.constraints[i];
    const auto add = [&](double sign, double limit, auto* into) {
      sides.push_back({&counted, 1 + i, sign, limit});
      into(opt, side, &sides.back(), 1e-8);
    };
    if (c.lower == c.upper) {
      add(1.0, c.lower, nlopt_add_equality_constraint);
      continue;
    }
    if (std::isfinite(c.upper)) add(1.0, c.upper, nlopt_add_inequality_constraint);
    if (std::isfinite(c.lower)) add(-1.0, c.lower, nlopt_add_inequality_constraint);
  }
  nlopt_set_xtol_rel(opt, 1e-10);
  nlopt_set_maxeval(opt, 3000);
  DirectAnswer answer;
  answer.design = optim::start_design(problem);
  double f = 0.0;
  nlopt_optimize(opt, answer.design.data(), &f);
  nlopt_destroy(opt);
  answer.evaluations = counted.count();
  return answer;
}

DirectAnswer ipopt_directly(const Problem& problem) {
  Counted counted(problem);
  const Ipopt::SmartPtr<Tnlp> tnlp = new Tnlp(counted);
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new Ipopt::IpoptApplication(true);
  app->Options()->SetStringValue("hessian_approximation", "limited-memory");
  app->Options()->SetIntegerValue("print_level", 0);
  app->Options()->SetStringValue("sb", "yes");
  app->Initialize("");
  app->OptimizeTNLP(Ipopt::GetRawPtr(tnlp));
  return {tnlp->answer, counted.count()};
}

}  // namespace twum::bench
