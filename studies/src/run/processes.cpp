// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/processes.hpp>

#include "entries/resolved_study.hpp"
#include "kinds/rows/executor.hpp"
#include "kinds/rows/row_bytes.hpp"
#include "run/channel.hpp"
#include "run/row_message.hpp"
#include "run/shared_executor.hpp"
#include "stored/result_of.hpp"

#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>
#include <twum/base/version.hpp>

#include <sched.h>
#include <algorithm>
#include <thread>

namespace twum::inline v0_1::studies {
namespace {

constexpr int kGreeting = 0;  // the lane of greetings; those of threads follow

// The first message of a process to the first process.
struct Greeting {
  std::string problem;  // why it cannot take part, or empty
  std::string version;
  std::string hash;
  std::uint64_t jobs{0};
};

std::string message_of(const Greeting& greeting) {
  std::string bytes;
  for (const std::string* text : {&greeting.problem, &greeting.version, &greeting.hash})
    append_text(bytes, *text);
  append_bytes(bytes, greeting.jobs);
  return bytes;
}

Greeting greeting_of(const std::string& message) {
  RowBytes bytes(message);
  Greeting greeting;
  for (std::string* text : {&greeting.problem, &greeting.version, &greeting.hash})
    *text = bytes.text();
  greeting.jobs = bytes.take<std::uint64_t>();
  return greeting;
}

void require_same(unsigned process, const Greeting& greeting, const std::string& hash) {
  const std::string name = "process " + std::to_string(process) + " ";
  if (!greeting.problem.empty())
    throw InputError(name +
                     "cannot read the study that the first process reads: " + greeting.problem);
  if (greeting.version != version())
    throw InputError(name + "is twum " + greeting.version + ", the first process " + version() +
                     "; start the same program everywhere");
  if (greeting.hash != hash)
    throw InputError(
        name +
        "reads another study under the same name than the first process; start them in "
        "a folder that all machines share");
}

// Processors that this process may use.
unsigned processors() {
  cpu_set_t set;
  CPU_ZERO(&set);
  if (sched_getaffinity(0, sizeof set, &set) != 0) return job_count(0);
  return static_cast<unsigned>(std::max(CPU_COUNT(&set), 1));
}

// Answers the messages of one lane until an empty message arrives.
void answer_lane(Channel& channel, int lane, ThreadExecutor& executor) {
  for (std::string asked = channel.receive(0, lane); !asked.empty();
       asked = channel.receive(0, lane))
    channel.send(0, lane, answer_of(asked, executor));
}

}  // namespace

// Another process, as the first knows it.
struct Processes::Member {
  unsigned process;
  unsigned jobs;
};

Processes::Processes() : channel_(std::make_unique<Channel>()) {
  const unsigned count = channel_->count(), number = channel_->number();
  if (count == launched_processes() && number == launched_number()) return;
  throw Error(
      "mpirun started this process as number " + std::to_string(launched_number()) + " of " +
      std::to_string(launched_processes()) + ", but the loaded MPI library reports number " +
      std::to_string(number) + " of " + std::to_string(count) +
      ": this is not the MPI library of that mpirun; use the mpirun of the MPI library that "
      "twum was built with, and load no other library with the same functions, such as "
      "sequential MUMPS");
}

Processes::~Processes() {
  if (!first()) return;
  try {
    for (unsigned process = 1; !met_ && process < channel_->count(); ++process) {
      channel_->receive(process, kGreeting);
      channel_->send(process, kGreeting, {});
    }
    for (const Member& member : members_)
      for (unsigned job = 0; job < member.jobs; ++job)
        channel_->send(member.process, static_cast<int>(1 + job), {});
  } catch (const std::exception&) {
    // The others wait; the launcher ends them with this process.
  }
}

bool Processes::first() const noexcept { return channel_->number() == 0; }

unsigned Processes::own_jobs(unsigned asked) const {
  if (asked > 0) return asked;
  return std::clamp(job_count(0) / channel_->on_node(), 1U, processors());
}

void Processes::serve(const std::string& path, const std::vector<std::string>& settings,
                      unsigned jobs) {
  Greeting greeting{{}, version(), {}, own_jobs(jobs)};
  std::unique_ptr<StudyFile> file;
  std::unique_ptr<StudyKindRun> kind;
  try {
    file = std::make_unique<StudyFile>(read_study_file(path, settings));
    kind = make_kind(*file);
    greeting.hash = resolve(*file).hash();
  } catch (const std::exception& error) {
    greeting.problem = error.what();
  }
  channel_->send(0, kGreeting, message_of(greeting));
  if (channel_->receive(0, kGreeting).empty()) return;
  ThreadExecutor executor(*kind, static_cast<unsigned>(greeting.jobs));
  std::vector<std::jthread> threads;
  for (int lane = 2; lane <= static_cast<int>(executor.lanes()); ++lane)
    threads.emplace_back([this, lane, &executor] { answer_lane(*channel_, lane, executor); });
  answer_lane(*channel_, 1, executor);
}

// Once all have said that they can take part, they are told to begin.
void Processes::meet(const std::string& hash) {
  std::vector<Greeting> greetings;
  for (unsigned process = 1; process < channel_->count(); ++process)
    greetings.push_back(greeting_of(channel_->receive(process, kGreeting)));
  met_ = true;
  std::string problem;
  try {
    for (unsigned process = 1; process < channel_->count(); ++process)
      require_same(process, greetings[process - 1], hash);
  } catch (const InputError&) {
    for (unsigned process = 1; process < channel_->count(); ++process)
      channel_->send(process, kGreeting, {});
    throw;
  }
  for (unsigned process = 1; process < channel_->count(); ++process) {
    channel_->send(process, kGreeting, "begin");
    members_.push_back({process, static_cast<unsigned>(greetings[process - 1].jobs)});
  }
}

std::unique_ptr<Executor> Processes::executor(const StudyKindRun& kind, const std::string& hash,
                                              unsigned jobs) {
  if (!met_) meet(hash);
  std::vector<SharedExecutor::Lane> lanes;
  for (const Member& member : members_)
    for (unsigned job = 0; job < member.jobs; ++job)
      lanes.push_back({member.process, static_cast<int>(1 + job)});
  return std::make_unique<SharedExecutor>(kind, own_jobs(jobs), *channel_, std::move(lanes));
}

}  // namespace twum::inline v0_1::studies
