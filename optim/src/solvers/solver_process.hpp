// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "solvers/nlopt_job.hpp"

#include <sys/types.h>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace twum::inline v0_1::optim {

/// The command of use_solver_process(); empty: none.
const std::vector<std::string>& solver_process();

/// A process for C code that may compute forever between two requests, such as the inner loop of a solver: other than a
/// thread, it can be ended. Requests are answered by the thread that calls run(), which waits meanwhile, so results do
/// not depend on timing. The process also ends with the thread that made it.
class SolverProcess {
 public:
  /// @param command  runs serve_solver(); not empty
  /// @param most     computing time between two requests after which the process is ended [s]. It does not depend on the
  ///                 load of the machine.
  /// @param hurried  called about fifty times a second while the process computes. If it returns true, the process is
  ///                 ended after 0.05 s of computing. It must not throw.
  /// @throws std::system_error if no process can be started
  SolverProcess(const std::vector<std::string>& command, double most,
                std::function<bool()> hurried);
  ~SolverProcess();
  SolverProcess(const SolverProcess&) = delete;
  SolverProcess& operator=(const SolverProcess&) = delete;

  /// run_job() there. Nothing if the process had to be ended, now or before. The job's functions have no gradients.
  std::optional<NloptEnd> run(const NloptJob& job, NloptRequests& requests);

 private:
  bool wait_for_message() const;
  double computed() const;
  void end();

  double most_;
  std::function<bool()> hurried_;
  pid_t process_{-1};  // -1: ended
  int socket_{-1};
};

}  // namespace twum::inline v0_1::optim
