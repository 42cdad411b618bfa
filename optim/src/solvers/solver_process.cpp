// SPDX-License-Identifier: Apache-2.0
#include "solvers/solver_process.hpp"

#include <twum/base/error.hpp>
#include <twum/optim/solver_process.hpp>

#include <poll.h>
#include <spawn.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>
#include <algorithm>
#include <bit>
#include <cerrno>
#include <csignal>
#include <ctime>
#include <system_error>

namespace twum::inline v0_1::optim {
namespace {

constexpr int kLook = 20;        // [ms]
constexpr double kHurry = 0.05;  // computing time [s]; a regular step takes microseconds

enum class Topic : std::uint32_t { job, objective, inequalities, equalities, answer, end };

struct Message {
  Topic topic{};
  std::vector<double> values;
};

struct Head {
  Topic topic;
  std::uint32_t count;
};

// All of it, or false if the other side has closed.
bool send_all(int socket, const void* data, std::size_t size) {
  const char* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::send(socket, from, size, MSG_NOSIGNAL);
    if (sent < 0 && errno == EINTR) continue;
    if (sent <= 0) return false;
    from += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool receive_all(int socket, void* data, std::size_t size) {
  char* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::recv(socket, to, size, 0);
    if (got < 0 && errno == EINTR) continue;
    if (got <= 0) return false;
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool send(int socket, const Message& message) {
  const Head head{message.topic, static_cast<std::uint32_t>(message.values.size())};
  return send_all(socket, &head, sizeof head) &&
         send_all(socket, message.values.data(), head.count * sizeof(double));
}

bool receive(int socket, Message& message) {
  Head head{};
  if (!receive_all(socket, &head, sizeof head)) return false;
  message.topic = head.topic;
  message.values.resize(head.count);
  return receive_all(socket, message.values.data(), head.count * sizeof(double));
}

// The members of a job one after the other, each list behind its length.
class Writer {
 public:
  void number(double value) { values_.push_back(value); }
  void list(const std::vector<double>& list) {
    number(static_cast<double>(list.size()));
    values_.insert(values_.end(), list.begin(), list.end());
  }
  std::vector<double> take() { return std::move(values_); }

 private:
  std::vector<double> values_;
};

class Reader {
 public:
  explicit Reader(const std::vector<double>& values) : values_(values) {}
  double number() {
    TWUM_ASSERT(at_ < values_.size());
    return values_[at_++];
  }
  template <typename T>
  void read(T& value) {
    value = static_cast<T>(number());
  }
  void read(std::vector<double>& list) {
    const auto size = static_cast<std::size_t>(number());
    TWUM_ASSERT(size <= values_.size() - at_);
    const auto begin = values_.begin() + static_cast<std::ptrdiff_t>(at_);
    list.assign(begin, begin + static_cast<std::ptrdiff_t>(size));
    at_ += size;
  }

 private:
  const std::vector<double>& values_;
  std::size_t at_{0};
};

Message message_of(const NloptJob& job) {
  Writer out;
  for (const double value :
       {double(job.id), double(job.subsidiary), job.xtol_rel, job.ftol_rel, double(job.calls),
        double(job.inner_calls), double(job.population), double(job.vector_storage)})
    out.number(value);
  for (const auto* list :
       {&job.lower, &job.upper, &job.start, &job.inequalities, &job.equalities, &job.steps})
    out.list(*list);
  out.list(job.seed ? std::vector<double>{std::bit_cast<double>(*job.seed)}
                    : std::vector<double>{});
  return {Topic::job, out.take()};
}

NloptJob job_of(const Message& message) {
  NloptJob job;
  Reader in(message.values);
  in.read(job.id);
  in.read(job.subsidiary);
  in.read(job.xtol_rel);
  in.read(job.ftol_rel);
  for (int* count : {&job.calls, &job.inner_calls, &job.population, &job.vector_storage})
    in.read(*count);
  for (auto* list :
       {&job.lower, &job.upper, &job.start, &job.inequalities, &job.equalities, &job.steps})
    in.read(*list);
  std::vector<double> seed;
  in.read(seed);
  if (!seed.empty()) job.seed = std::bit_cast<std::uint64_t>(seed.front());
  return job;
}

Message message_of(const NloptEnd& end) {
  Writer out;
  out.number(end.code);
  out.list(end.z);
  out.list({end.error.begin(), end.error.end()});
  return {Topic::end, out.take()};
}

NloptEnd end_of(const Message& message) {
  NloptEnd end;
  Reader in(message.values);
  in.read(end.code);
  in.read(end.z);
  std::vector<double> letters;
  in.read(letters);
  for (const double letter : letters) end.error += static_cast<char>(letter);
  return end;
}

// In the process of the solver: passes requests on. The first value of an answer says whether the search is halted.
class RemoteRequests : public NloptRequests {
 public:
  double objective(std::span<const double> z, double* /*gradient*/) override {
    ask(Topic::objective, z);
    return answer_.values.at(1);
  }
  void limits(Rows rows, std::span<const double> z, std::span<double> result,
              double* /*jacobian*/) override {
    ask(rows == Rows::inequalities ? Topic::inequalities : Topic::equalities, z);
    std::copy_n(answer_.values.begin() + 1, result.size(), result.begin());
  }
  bool halted() const override { return answer_.values.front() != 0.0; }

 private:
  // Nobody is left who wants an answer if the other side has closed.
  void ask(Topic topic, std::span<const double> z) {
    if (!send(STDIN_FILENO, {topic, {z.begin(), z.end()}}) || !receive(STDIN_FILENO, answer_))
      ::_exit(0);
  }

  Message answer_;
};

// In the process of the search.
Message answer_to(const Message& asked, const NloptJob& job, NloptRequests& requests) {
  Message answer{Topic::answer, {0.0}};
  if (asked.topic == Topic::objective) {
    answer.values.push_back(requests.objective(asked.values, nullptr));
  } else {
    const bool inequalities = asked.topic == Topic::inequalities;
    answer.values.resize(1 + (inequalities ? job.inequalities : job.equalities).size());
    requests.limits(
        inequalities ? NloptRequests::Rows::inequalities : NloptRequests::Rows::equalities,
        asked.values, std::span(answer.values).subspan(1), nullptr);
  }
  answer.values.front() = requests.halted() ? 1.0 : 0.0;
  return answer;
}

[[noreturn]] void refuse_to_start(int error) {
  throw std::system_error(error, std::generic_category(), "cannot start a process for a solver");
}

// A signal from the terminal goes to the program, which decides; so the process is in a group of its own.
pid_t spawn(const std::vector<std::string>& command, int input) {
  std::vector<char*> words;
  for (const std::string& word : command) words.push_back(const_cast<char*>(word.c_str()));
  words.push_back(nullptr);
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, input, STDIN_FILENO);
  posix_spawnattr_t settings;
  posix_spawnattr_init(&settings);
  posix_spawnattr_setflags(&settings, POSIX_SPAWN_SETPGROUP);
  pid_t process = -1;
  const int failed =
      ::posix_spawnp(&process, words.front(), &files, &settings, words.data(), environ);
  posix_spawnattr_destroy(&settings);
  posix_spawn_file_actions_destroy(&files);
  if (failed != 0) refuse_to_start(failed);
  return process;
}

std::vector<std::string>& command_in_use() {
  static std::vector<std::string> command;
  return command;
}

}  // namespace

void use_solver_process(std::vector<std::string> command) { command_in_use() = std::move(command); }

const std::vector<std::string>& solver_process() { return command_in_use(); }

int serve_solver() {
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  Message asked;
  while (receive(STDIN_FILENO, asked)) {
    RemoteRequests requests;
    if (!send(STDIN_FILENO, message_of(run_job(job_of(asked), requests)))) break;
  }
  return 0;
}

SolverProcess::SolverProcess(const std::vector<std::string>& command, double most,
                             std::function<bool()> hurried)
    : most_(most), hurried_(std::move(hurried)) {
  int ends[2];
  if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0) refuse_to_start(errno);
  socket_ = ends[0];
  try {
    process_ = spawn(command, ends[1]);
  } catch (...) {
    ::close(ends[0]);
    ::close(ends[1]);
    throw;
  }
  ::close(ends[1]);
}

SolverProcess::~SolverProcess() {
  end();
  ::close(socket_);
}

std::optional<NloptEnd> SolverProcess::run(const NloptJob& job, NloptRequests& requests) {
  if (process_ < 0 || !send(socket_, message_of(job))) return std::nullopt;
  Message message;
  while (wait_for_message() && receive(socket_, message)) {
    if (message.topic == Topic::end) return end_of(message);
    if (!send(socket_, answer_to(message, job, requests))) break;
  }
  end();
  return std::nullopt;
}

// False if the process has computed for too long.
bool SolverProcess::wait_for_message() const {
  double begun = -1.0;
  pollfd wanted{socket_, POLLIN, 0};
  while (::poll(&wanted, 1, kLook) <= 0) {
    const double now = computed();
    if (begun < 0.0) begun = now;
    if (now - begun > (hurried_() ? kHurry : most_)) return false;
  }
  return true;
}

// Computing time of the process [s].
double SolverProcess::computed() const {
  clockid_t clock{};
  timespec time{};
  if (::clock_getcpuclockid(process_, &clock) != 0 || ::clock_gettime(clock, &time) != 0)
    return 0.0;
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

void SolverProcess::end() {
  if (process_ < 0) return;
  ::kill(process_, SIGKILL);
  while (::waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
  process_ = -1;
}

}  // namespace twum::inline v0_1::optim
