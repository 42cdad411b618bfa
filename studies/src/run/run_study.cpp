// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/run_study.hpp>

#include "entries/resolved_study.hpp"
#include "kinds/rows/executor.hpp"
#include "kinds/rows/study_kind.hpp"
#include "kinds/sample/found_motors.hpp"
#include "results/provenance.hpp"
#include "results/row_pass.hpp"
#include "run/verify_checks.hpp"
#include "store/written_content.hpp"
#include "stored/result_folder.hpp"
#include "stored/result_of.hpp"
#include "text/file_content.hpp"

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>
#include <twum/studies/processes.hpp>
#include <twum/studies/report.hpp>

#include <array>
#include <filesystem>
#include <mutex>

namespace twum::inline v0_1::studies {
namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t kDifferencesShown = 8;
// rows that are computed again before a run resumes, which detects another build
constexpr std::uint64_t kRowsRepeated = 8;

std::string name_of(const StudyFile& file) {
  const std::string stem = std::filesystem::path(file.path).stem().string();
  return stem.empty() || stem == "-" ? "study" : stem;
}

// Forwards progress from any thread to the listener, one call at a time. A call that would have to wait is dropped.
std::function<void(const RunProgress&)> forwarded(const RunOptions& options) {
  if (!options.progress) return {};
  const auto mutex = std::make_shared<std::mutex>();
  return [mutex, tell = options.progress](const RunProgress& now) {
    const std::unique_lock lock(*mutex, std::try_to_lock);
    if (lock) tell(now);
  };
}

std::unique_ptr<Executor> executor_of(const StudyFile& file, const StudyKindRun& kind,
                                      const RunOptions& options) {
  if (options.processes == nullptr) return std::make_unique<ThreadExecutor>(kind, options.jobs);
  return options.processes->executor(kind, resolve(file).hash(), options.jobs);
}

// Runs a kind on a store. After a stop request the rows are incomplete, whatever outcome the kind returns.
StudyResult run_on(const StudyFile& file, StudyKindRun& kind, ResultStore& store,
                   const RunOptions& options) {
  const std::unique_ptr<Executor> executor = executor_of(file, kind, options);
  RunContext context{store, *executor, options.stop, forwarded(options)};
  KindAnswer answer = kind.run(context);
  store.flush();
  if (options.stop.stop_requested()) answer.outcome = StudyOutcome::interrupted;
  StudyResult result = result_of(file, kind, store, std::move(answer));
  result.study = name_of(file);
  return result;
}

double seconds_since(Clock::time_point begin) {
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::string files_text(const ResolvedStudy& study) {
  std::string text;
  for (const auto& file : study.files) text += file.entry + " " + file.hash + "\n";
  return text;
}

// The study in a directory is a file, which cannot hold a function.
void refuse_own_metrics(const StudyFile& file) {
  const OwnMetrics own = own_metrics(file.asked);
  if (own.empty()) return;
  throw InputError(
      "study: " + quoted(own.front()->name) +
      " is a metric of this program, which a study file cannot have; run the study in memory, "
      "without a directory");
}

// A study in its directory.
class KeptRun {
 public:
  KeptRun(const StudyFile& file, const std::string& directory, const RunOptions& options)
      : file_(file),
        options_(options),
        begin_(Clock::now()),
        kind_(make_kind(file)),
        study_(resolve(file)),
        folder_(refuse_own(file, directory)),
        directory_(directory) {}

  StudyResult run() {
    if (options_.fresh) folder_.discard();
    open_store();
    keep_inputs();
    folder_.write(ResultFolder::kStudy, study_text());
    const bool was_complete = !store_->fact(facts::kComplete).empty();
    StudyResult result = run_on(file_, *kind_, *store_, options_);
    result.was_complete = was_complete;
    result.hash = study_.hash();
    result.started = store_->fact(facts::kStarted);
    result.seconds = parse_number(store_->fact(facts::kSeconds)).value_or(0);
    if (!was_complete) {
      result.seconds += seconds_since(begin_);
      store_->set_fact(facts::kSeconds, number_text(result.seconds));
    }
    write_results(result);
    if (result.outcome != StudyOutcome::interrupted) store_->set_fact(facts::kComplete, "yes");
    read_back();
    return result;
  }

 private:
  // Refuses a study that lies in the directory as study.yaml, because the result would overwrite it.
  static const std::string& refuse_own(const StudyFile& file, const std::string& directory) {
    std::error_code ignored;
    const auto result = std::filesystem::path(directory) / ResultFolder::kStudy;
    if (std::filesystem::equivalent(file.path, result, ignored)) {
      throw InputError(result.string() +
                       ": is the study itself and would be overwritten by its "
                       "result; choose another directory with -o");
    }
    return directory;
  }

  void open_store() {
    folder_.check_ours();
    folder_.check_not_emptied();
    const std::string path = folder_.file(ResultFolder::kDatabase);
    if (folder_.has_database()) {
      store_ = begun_already(path);
      if (store_ != nullptr) return;
      folder_.discard();
    }
    const std::string copies = copies_text();
    store_ = std::make_unique<ResultStore>(path, kind_->columns());
    store_->set_fact(facts::kCopies, copies);
    store_->set_fact(facts::kVersion, version());
    store_->set_fact(facts::kStudyText, study_.text());
    store_->set_fact(facts::kFiles, files_text(study_));
    store_->set_fact(facts::kStarted, utc_text(std::chrono::system_clock::now()));
    // written last: if it exists, the others do, too
    store_->set_fact(facts::kHash, study_.hash());
  }

  // Whether a file of the study is the one in this directory, as in a run of the study that is kept here.
  bool stands_here(const ResolvedStudy::NamedFile& file) const {
    std::error_code ignored;
    return std::filesystem::equivalent(file.source(), folder_.file(file.kept()), ignored);
  }

  // The copies that this run will make. A file in the place of one is not overwritten.
  std::string copies_text() const {
    std::string text;
    for (const ResolvedStudy::NamedFile& file : study_.files) {
      if (file.copy.empty() || stands_here(file)) continue;
      if (folder_.has(file.kept()) &&
          file_content(folder_.file(file.kept()), kLargestResult) != content_of(file))
        throw InputError(folder_.file(file.kept()) +
                         ": exists already and is no copy that twum made; choose another directory "
                         "with -o, or remove it yourself");
      text += file.kept() + "\n";
    }
    return text;
  }

  // Copies of the files that the study names, so that the results can be read again without them.
  void keep_inputs() {
    for (const ResolvedStudy::NamedFile& file : study_.files)
      if (!file.copy.empty() && !stands_here(file)) folder_.write(file.kept(), content_of(file));
  }

  // The database if it holds rows of the same study; none if the run ended before its first row.
  std::unique_ptr<ResultStore> begun_already(const std::string& path) const {
    auto stored = std::make_unique<ResultStore>(path);
    const std::string hash = stored->fact(facts::kHash);
    if (hash.empty() || stored->rows() == 0) return nullptr;
    std::vector<std::string> differ;
    if (hash != study_.hash() && !begins_here(*stored)) {
      differ = differences(stored->fact(facts::kStudyText), study_.text());
      for (const ResolvedStudy::NamedFile& file : study_.files)
        if (!has_line(stored->fact(facts::kFiles), file.entry + " " + file.hash))
          differ.push_back("the content of a file that the study names: " + file.source());
    }
    if (stored->fact(facts::kVersion) != version())
      differ.push_back("twum: " + stored->fact(facts::kVersion) + " there, " + version() + " here");
    if (!differ.empty()) refuse("holds the results of another study; it differs in", differ);
    check_repeats(*stored);
    if (hash != study_.hash()) grow(*stored);
    return stored;
  }

  // Whether the study differs from that of the rows only in having more of them.
  bool begins_here(const ResultStore& stored) const {
    const std::string entry(kind_->grows_by());
    const std::vector<std::string> differ =
        differences(stored.fact(facts::kStudyText), study_.text());
    const bool alone = differ.empty() || (differ.size() == 1 && !entry.empty() &&
                                          differ.front().starts_with(entry + ": "));
    if (!alone || stored.fact(facts::kFiles) != files_text(study_)) return false;
    const std::uint64_t last = stored.rows() - 1;
    return kind_->recompute({0, last, {}, "ok", {}}).has_value();
  }

  // The rows now belong to this study. Its hash comes last: a run that ends before it begins anew here.
  void grow(ResultStore& stored) const {
    stored.set_fact(facts::kComplete, "");
    stored.set_fact(facts::kStudyText, study_.text());
    stored.set_fact(facts::kHash, study_.hash());
  }

  // Another build of this version may compute other numbers, and one result would mix the two.
  void check_repeats(const ResultStore& stored) const {
    Verification found;
    verify_rows(*kind_, stored, {.samples = kRowsRepeated}, found);
    if (found.holds()) return;
    refuse(
        "holds numbers that this program does not reproduce; they are from another build, or "
        "damaged:",
        found.complaints);
  }

  [[noreturn]] void refuse(const std::string& what, const std::vector<std::string>& differ) const {
    std::string text = directory_ + ": " + what;
    for (std::size_t i = 0; i < differ.size() && i < kDifferencesShown; ++i)
      text += "\n  " + differ[i];
    if (differ.size() > kDifferencesShown)
      text += "\n  and " + std::to_string(differ.size() - kDifferencesShown) + " more";
    throw InputError(text +
                     "\nchoose another directory with -o, or discard those results with --fresh");
  }

  std::string study_text() const {
    return "# The study " + printable(name_of(file_), 255) + " as it was run: the motor in full, " +
           "every default written out.\n# Hash " + study_.hash() + ", twum " + version() + ".\n" +
           study_.text(directory_);
  }

  void write_results(StudyResult& result) {
    const auto fill = [&](const std::function<void(std::string_view)>& put) {
      set_failures(result, write_rows(*store_, kind_->columns(), kind_->variables(), put));
    };
    folder_.write(ResultFolder::kTable, fill);
    if (file_.kind() == StudyKind::motion) folder_.write(ResultFolder::kMotion, fill);
    folder_.write(ResultFolder::kSummary, summary_json(result));
    for (const FoundMotor& found : found_motors(file_, result)) {
      folder_.write(found.file, found_motor_text(found, result));
      result.motor_files.push_back(found.file);
    }
    folder_.write(ResultFolder::kReport, report_html(file_, study_text(), result, *store_));
  }

  // Reads the files again, because another program may have damaged them after they were written without an error.
  void read_back() {
    const std::uint64_t rows = store_->rows();
    store_.reset();
    const ResultStore stored(folder_.file(ResultFolder::kDatabase), kind_->columns());
    if (stored.rows() != rows) {
      throw StoreError(folder_.file(ResultFolder::kDatabase) + ": holds " +
                       std::to_string(stored.rows()) + " rows, but " + std::to_string(rows) +
                       " were written; run the study again");
    }
    folder_.check_in_place();
  }

  const StudyFile& file_;
  const RunOptions& options_;
  Clock::time_point begin_;
  std::unique_ptr<StudyKindRun> kind_;
  ResolvedStudy study_;
  ResultFolder folder_;
  std::string directory_;
  std::unique_ptr<ResultStore> store_;
};

}  // namespace

StudyResult run_study(const StudyFile& file, const std::string& directory,
                      const RunOptions& options) {
  validate(file);
  refuse_own_metrics(file);
  return KeptRun(file, directory, options).run();
}

StudyResult run_study(const StudyFile& file, const RunOptions& options) {
  validate(file);
  const OwnMetrics own = own_metrics(file.asked);
  const KnownMetrics known(own);
  const auto begin = Clock::now();
  const std::string started = utc_text(std::chrono::system_clock::now());
  const std::unique_ptr<StudyKindRun> kind = make_kind(file);
  const auto store = std::make_shared<ResultStore>(":memory:", kind->columns());
  StudyResult result = run_on(file, *kind, *store, options);
  set_failures(result, failures_of(*kind, *store));
  result.rows = store;
  result.own_metrics = own;
  result.hash = resolve(file).hash();
  result.started = started;
  result.seconds = seconds_since(begin);
  return result;
}

namespace {

const ResultStore& rows_of(const StudyResult& result) {
  if (!result.rows)
    throw InputError("this result has no rows: those of a run in a directory are in its files");
  return *result.rows;
}

}  // namespace

std::string results_csv(const StudyResult& result) {
  const ResultStore& rows = rows_of(result);
  std::string text;
  write_rows(rows, rows.columns(), 0, [&](std::string_view piece) { text += piece; });
  return text;
}

std::string report_html(const StudyFile& study, const StudyResult& result) {
  std::string text = resolve(study).text();
  for (const auto& own : result.own_metrics)
    text += "# " + own->name + " [" + own->unit + "] is a metric of the program that asked.\n";
  return report_html(study, text, result, rows_of(result));
}

}  // namespace twum::inline v0_1::studies
