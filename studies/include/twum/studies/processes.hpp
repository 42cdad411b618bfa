// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

class Channel;
class Executor;
class StudyKindRun;

/// Number of processes that a launcher such as mpirun has started together, including this one; 1 without a launcher.
unsigned launched_processes();

/// Number of this process among them, from 0.
unsigned launched_number();

/// The processes that a launcher has started together to run one study. The first process reads the study, asks the
/// others for rows, and stores and reports the results. The others compute rows and write nothing. The rows and the
/// results are the same as with one process.
///
///     Processes processes;
///     if (!processes.first()) return processes.serve("study.yaml", {}, 0);
///     RunOptions options;
///     options.processes = &processes;
///     run_study(read_study_file("study.yaml"), "results", options);
///
/// A program may create one such object only.
class Processes {
 public:
  /// Joins the other processes and waits for them.
  /// @throws InputError if this build has no MPI; Error if MPI reports another number of processes than the launcher
  Processes();
  /// Waits for all processes; the first one tells the others to end.
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Whether this is the process that stores and reports.
  bool first() const noexcept;

  /// For all processes but the first: computes rows for the first process until it is done. Errors in the study are
  /// reported by the first process.
  /// @param path      the study file, which every process reads for itself
  /// @param settings  as of read_study_file()
  /// @param jobs      threads; 0 takes the processors that belong to this process alone
  void serve(const std::string& path, const std::vector<std::string>& settings, unsigned jobs);

  /// For the first process: an executor that uses the threads of all processes. Called by run_study() for
  /// RunOptions::processes.
  /// @param hash  hash of the study, which has to be the same in all processes
  /// @throws InputError naming a process that has another study or another version of twum, or cannot read it
  std::unique_ptr<Executor> executor(const StudyKindRun& kind, const std::string& hash,
                                     unsigned jobs);

 private:
  struct Member;
  unsigned own_jobs(unsigned asked) const;
  void meet(const std::string& hash);

  std::unique_ptr<Channel> channel_;
  std::vector<Member> members_;  // of the first process: the others
  bool met_{false};
};

}  // namespace twum::inline v0_1::studies
