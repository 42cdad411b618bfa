// SPDX-License-Identifier: Apache-2.0
#include "solvers/allowance.hpp"
#include "solvers/ipopt_options.hpp"
#include "solvers/optimizer.hpp"

#include <chrono>
#include <cmath>
#include <coin/IpIpoptApplication.hpp>
#include <coin/IpTNLP.hpp>
#include <exception>
#include <mutex>

namespace twum::inline v0_1::optim {
namespace {

using Ipopt::Index;
using Ipopt::Number;
constexpr double kIpoptInfinity = 2e19;  // what Ipopt takes as no bound

// One thread at a time is in the code of Ipopt, because the sequential MUMPS under it keeps global state during a call.
// A thread leaves the code while it evaluates a design. So solves share Ipopt, and an evaluator may itself solve with it.
std::timed_mutex& ipopt_lock() {
  static std::timed_mutex lock;
  return lock;
}
using IpoptTurn = std::unique_lock<std::timed_mutex>;

// Gives the turn to others in its scope.
class TurnPassed {
 public:
  explicit TurnPassed(IpoptTurn& turn) : turn_(turn) { turn_.unlock(); }
  ~TurnPassed() { turn_.lock(); }
  TurnPassed(const TurnPassed&) = delete;
  TurnPassed& operator=(const TurnPassed&) = delete;

 private:
  IpoptTurn& turn_;
};

// Waits for the first turn of a solve. @throws Stop if the solve must end before
void take_turn(IpoptTurn& turn, const Session& session) {
  constexpr std::chrono::milliseconds kLook{10};
  // By the system's clock, whose lock the thread sanitizer knows; a clock that is set only makes one look shorter or longer.
  do session.heed();
  while (!turn.try_lock_until(std::chrono::system_clock::now() + kLook));
}

// The callbacks of one run. They never throw into Ipopt; an evaluation that failed is answered
// with false, whereupon Ipopt tries a shorter step.
class Bridge : public Ipopt::TNLP {
 public:
  Bridge(Nlp& nlp, std::span<const double> start, std::size_t calls, IpoptTurn& turn)
      : nlp_(nlp),
        start_(start.begin(), start.end()),
        allowance_(nlp, calls, Allowance::Search::local),
        turn_(turn) {}

  bool get_nlp_info(Index& n, Index& m, Index& jacobian, Index& hessian,
                    IndexStyleEnum& style) override {
    n = static_cast<Index>(nlp_.size());
    m = static_cast<Index>(nlp_.rows());
    jacobian = n * m;
    hessian = 0;
    style = C_STYLE;
    return true;
  }

  bool get_bounds_info(Index, Number* lower, Number* upper, Index, Number* row_lower,
                       Number* row_upper) override {
    std::copy(nlp_.lower().begin(), nlp_.lower().end(), lower);
    std::copy(nlp_.upper().begin(), nlp_.upper().end(), upper);
    for (std::size_t i = 0; i < nlp_.rows(); ++i) {
      const double room = nlp_.equality(i) && too_many_equalities() ? 0.5 * nlp_.tolerance(i) : 0.0;
      row_lower[i] = std::max(nlp_.row(i).lower - room, -kIpoptInfinity);
      row_upper[i] = std::min(nlp_.row(i).upper + room, kIpoptInfinity);
    }
    return true;
  }

  bool get_starting_point(Index, bool, Number* z, bool, Number*, Number*, Index, bool,
                          Number*) override {
    std::copy(start_.begin(), start_.end(), z);
    return true;
  }

  bool eval_f(Index n, const Number* z, bool, Number& value) override {
    const NlpValue* v = request(n, z);
    if (v != nullptr) value = v->f;
    return v != nullptr;
  }

  bool eval_grad_f(Index n, const Number* z, bool, Number* gradient) override {
    const NlpValue* v = request(n, z);
    if (v != nullptr) std::copy(v->df.begin(), v->df.end(), gradient);
    return v != nullptr;
  }

  bool eval_g(Index n, const Number* z, bool, Index, Number* rows) override {
    const NlpValue* v = request(n, z);
    if (v != nullptr) std::copy(v->c.begin(), v->c.end(), rows);
    return v != nullptr;
  }

  bool eval_jac_g(Index n, const Number* z, bool, Index m, Index, Index* row, Index* column,
                  Number* values) override {
    if (values == nullptr) {
      for (Index k = 0; k < n * m; ++k) {
        row[k] = k / n;
        column[k] = k % n;
      }
      return true;
    }
    const NlpValue* v = request(n, z);
    if (v != nullptr) std::copy(v->dc.begin(), v->dc.end(), values);
    return v != nullptr;
  }

  bool intermediate_callback(Ipopt::AlgorithmMode, Index iteration, Number, Number, Number, Number,
                             Number, Number, Number, Number, Index, const Ipopt::IpoptData*,
                             Ipopt::IpoptCalculatedQuantities*) override {
    iterations_ = iteration;
    return !halted();
  }

  void finalize_solution(Ipopt::SolverReturn, Index n, const Number* z, const Number*,
                         const Number*, Index, const Number*, const Number*, Number,
                         const Ipopt::IpoptData*, Ipopt::IpoptCalculatedQuantities*) override {
    final_.assign(z, z + n);
  }

  std::exception_ptr error() const { return error_; }
  StopReason stop() const { return stop_; }
  const std::vector<double>& final_point() const { return final_; }
  int iterations() const { return iterations_; }

 private:
  // Ipopt refuses more equalities than variables, although some may repeat others. As limits within half of what they
  // tolerate it takes them.
  bool too_many_equalities() const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < nlp_.rows(); ++i) count += nlp_.equality(i) ? 1U : 0U;
    return count > nlp_.size();
  }

  bool halted() const { return error_ || stop_ != StopReason::finished || allowance_.used_up(); }

  const NlpValue* request(Index n, const Number* z) {
    if (halted()) return nullptr;
    const std::span<const double> point(z, static_cast<std::size_t>(n));
    const TurnPassed passed(turn_);
    try {
      return allowance_.take(point) ? nlp_.at(point, true) : nullptr;
    } catch (const Stop& s) {
      stop_ = s.reason;
    } catch (...) {
      error_ = std::current_exception();
    }
    return nullptr;
  }

  Nlp& nlp_;
  std::vector<double> start_;
  Allowance allowance_;
  IpoptTurn& turn_;
  std::vector<double> final_;
  std::exception_ptr error_;
  StopReason stop_{StopReason::finished};
  int iterations_{0};
};

const char* word_of(Ipopt::ApplicationReturnStatus status) {
  switch (status) {
    case Ipopt::Solve_Succeeded: return "Solve_Succeeded";
    case Ipopt::Solved_To_Acceptable_Level: return "Solved_To_Acceptable_Level";
    case Ipopt::Infeasible_Problem_Detected: return "Infeasible_Problem_Detected";
    case Ipopt::Search_Direction_Becomes_Too_Small: return "Search_Direction_Becomes_Too_Small";
    case Ipopt::Diverging_Iterates: return "Diverging_Iterates";
    case Ipopt::User_Requested_Stop: return "User_Requested_Stop";
    case Ipopt::Feasible_Point_Found: return "Feasible_Point_Found";
    case Ipopt::Maximum_Iterations_Exceeded: return "Maximum_Iterations_Exceeded";
    case Ipopt::Restoration_Failed: return "Restoration_Failed";
    case Ipopt::Error_In_Step_Computation: return "Error_In_Step_Computation";
    case Ipopt::Not_Enough_Degrees_Of_Freedom: return "Not_Enough_Degrees_Of_Freedom";
    case Ipopt::Invalid_Number_Detected: return "Invalid_Number_Detected";
    default: return "Other";
  }
}

RunReport solve_locked(const Ipopt::SmartPtr<Bridge>& bridge, const IpoptSettings& settings) {
  RunReport report;
  const Ipopt::SmartPtr<Ipopt::IpoptApplication> app = new Ipopt::IpoptApplication(true);
  app->RethrowNonIpoptException(true);
  apply_ipopt_settings(settings, *app->Options());
  try {
    // The empty name keeps Ipopt from reading a file ipopt.opt in the working directory.
    if (app->Initialize("") != Ipopt::Solve_Succeeded) {
      report.word = "Initialization_Failed";
      return report;
    }
    const Ipopt::SmartPtr<Ipopt::TNLP> tnlp = Ipopt::GetRawPtr(bridge);
    const auto status = app->OptimizeTNLP(tnlp);
    report.word = word_of(status);
    report.code = static_cast<int>(status);
  } catch (const Ipopt::IpoptException& e) {  // not a std::exception
    report.word = "IpoptException: " + e.Message();
  }
  return report;
}

RunReport run_ipopt(const SolverInfo&, Nlp& nlp, std::span<const double> start,
                    const RunSettings& settings) {
  require_known_options(settings, ipopt_options());
  const IpoptSettings checked = check_ipopt_settings(settings);
  IpoptTurn turn(ipopt_lock(), std::defer_lock);
  try {
    take_turn(turn, nlp.session());
  } catch (const Stop& s) {
    RunReport none;
    none.word = "stopped before its start";
    none.stop = s.reason;
    return none;
  }
  // The counts of SmartPtr are not atomic: everything of Ipopt lives and dies under the lock.
  const Ipopt::SmartPtr<Bridge> bridge = new Bridge(nlp, start, settings.max_calls, turn);
  RunReport report = solve_locked(bridge, checked);
  if (bridge->error()) std::rethrow_exception(bridge->error());
  report.stop = bridge->stop();
  report.word += " after " + std::to_string(bridge->iterations()) + " iterations";
  report.z = bridge->final_point();
  return report;
}

}  // namespace

std::vector<Optimizer> ipopt_optimizers() {
  SolverInfo info;
  info.name = "ipopt";
  info.description =
      "interior point method with limited-memory Hessian; about a millisecond an iteration";
  info.gradient = true;
  info.inequality = true;
  info.equality = true;
  info.on_failure = FailurePolicy::shorter_step;
  return {{info, run_ipopt}};
}

}  // namespace twum::inline v0_1::optim
