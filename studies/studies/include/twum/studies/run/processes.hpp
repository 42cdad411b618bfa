// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>
#include <vector>

namespace twum::studies {

class Channel;
class Executor;
class StudyKindRun;

/// How many processes a launcher such as mpirun has started together, this one among them; 1 if none has.
unsigned launched_processes();

/// The number of this process among them, from 0.
unsigned launched_number();

/// The processes that a launcher has started together to run one study. The first reads the study, asks the others for
/// rows, stores and reports; the others compute what they are asked for and write nothing. The rows, and so the results,
/// are those of one process.
///
///     Processes processes;
///     if (!processes.first()) return processes.serve("study.yaml", {}, 0);
///     RunOptions options;
///     options.processes = &processes;
///     run_study(read_study_file("study.yaml"), "results", options);
///
/// At most one at a time, and one in the life of a program.
class Processes {
 public:
  /// Joins the others, and waits for them.
  /// @throws InputError if this build has no MPI; Error if MPI counts other processes than the launcher has started
  Processes();
  /// The first process lets the others go. Waits for all of them.
  ~Processes();
  Processes(const Processes&) = delete;
  Processes& operator=(const Processes&) = delete;

  /// Whether this is the process that stores and reports.
  bool first() const noexcept;

  /// For all but the first: answers the first process until it is done. What is wrong with the study here is said there.
  /// @param path      the study file, which every process reads for itself
  /// @param settings  as of read_study_file()
  /// @param jobs      threads; 0 takes the processors that this process has to itself
  void serve(const std::string& path, const std::vector<std::string>& settings, unsigned jobs);

  /// For the first: the threads of all processes. Used by RunOptions::processes.
  /// @param hash  of the study, which has to be the same in all processes
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

}  // namespace twum::studies
