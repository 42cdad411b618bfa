// SPDX-License-Identifier: Apache-2.0
// Runs studies.
#include "classes.hpp"
#include "conversions.hpp"
#include "interruptible.hpp"
#include "own_metric.hpp"
#include "parts.hpp"
#include "results/answers.hpp"
#include "stored/stored_study.hpp"
#include "study_node.hpp"
#include "telling/renderers.hpp"
#include "yaml/yaml_text.hpp"

#include <twum/motors/settings.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <mutex>
#include <optional>
#include <tuple>
#include <vector>

namespace twum::inline v0_1::python {
namespace {

struct Progress {
  std::uint64_t done{0};
  std::uint64_t total{0};
  std::string best;
};

// The latest progress of the run, for the thread that may call Python.
class Mailbox {
 public:
  void put(Progress progress) {
    const std::lock_guard lock(mutex_);
    latest_ = std::move(progress);
  }
  std::optional<Progress> take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(latest_, std::nullopt);
  }

 private:
  std::mutex mutex_;
  std::optional<Progress> latest_;
};

// Names of files may be of any bytes.
py::str text_of(const std::string& text) {
  return py::reinterpret_steal<py::str>(
      PyUnicode_DecodeUTF8(text.data(), static_cast<Py_ssize_t>(text.size()), "replace"));
}

// A number without a value is None.
py::object to_python(const studies::Json& value) {
  if (value.is_object()) {
    py::dict entries;
    for (const auto& [name, entry] : value.items()) entries[text_of(name)] = to_python(entry);
    return entries;
  }
  if (value.is_array()) {
    py::list items;
    for (const auto& item : value) items.append(to_python(item));
    return items;
  }
  if (value.is_string()) return text_of(value.get_ref<const std::string&>());
  if (value.is_boolean()) return py::bool_(value.get<bool>());
  if (value.is_number_unsigned()) return py::int_(value.get<std::uint64_t>());
  if (value.is_number_integer()) return py::int_(value.get<std::int64_t>());
  if (value.is_number()) return py::float_(value.get<double>());
  return py::none();
}

// Options of a run from Python.
struct RunArguments {
  std::string directory;  // empty: in memory
  unsigned jobs;
  bool fresh;
  py::object progress, stop;
};

// The content of summary.json, the words for it, and the table of a run in memory.
py::tuple run(const studies::StudyFile& file, const RunArguments& how) {
  RunningCall call;
  const Watch watch(how.stop, how.progress);
  Mailbox mailbox;
  studies::RunOptions options;
  options.jobs = how.jobs;
  options.fresh = how.fresh;
  options.progress = [&](const studies::RunProgress& now) {
    mailbox.put({now.done, now.budget ? 0 : now.total, now.best});  // a budget is not a total
  };
  const studies::StudyResult result = run_interruptible(
      call,
      [&](std::stop_token stop) {
        options.stop = stop;
        return how.directory.empty() ? studies::run_study(file, options)
                                     : studies::run_study(file, how.directory, options);
      },
      [&] {
        watch.heed(call);
        if (const auto now = mailbox.take()) watch.tell(now->done, now->total, now->best);
      });
  const py::object table =
      result.rows == nullptr ? py::object(py::none()) : py::str(studies::results_csv(result));
  // The rows of a directory are read when the HTML is asked for; an interrupted run has not all of them.
  const bool kept = !how.directory.empty() && result.outcome != studies::StudyOutcome::interrupted;
  return py::make_tuple(
      to_python(studies::summary_value(result)), studies::summary_text(result), table,
      kept ? "" : studies::telling::summary_html(result, {&file, result.rows.get()}));
}

// The answer of a result directory as HTML.
std::string kept_html(const std::string& directory) {
  const py::gil_scoped_release released;
  studies::StoredStudy stored(directory, {});
  return studies::telling::summary_html(stored.answer(), {&stored.file(), &stored.store()});
}

py::tuple run_file(const std::string& path, const std::string& directory,
                   const std::vector<std::string>& settings, unsigned jobs, bool fresh,
                   const py::object& progress, const py::object& stop) {
  return run(studies::read_study_file(path, settings), {directory, jobs, fresh, progress, stop});
}

// A study file with the entries of a dictionary, in which a Motor stands for its entries.
std::string study_text(const py::dict& study, const py::object& motor) {
  if (!py::isinstance<PyMotor>(motor))
    return yaml_text(to_node({}, study, studies::study_file_schema()), 0);
  const PyMotor& own = py::cast<const PyMotor&>(motor);
  py::dict rest = study.attr("copy")();
  for (const char* entry : {"twum", "motor"}) rest.attr("pop")(entry, py::none());
  return studies::motor_text({own.name, own.motor.design()}) +
         yaml_text(to_node({}, rest, studies::study_file_schema()), 0);
}

// A name, the function for its value, that for its gradient or None, and the unit.
using OwnTuple = std::tuple<py::str, py::object, py::object, std::string>;

std::vector<studies::OwnMetric> to_own_metrics(const std::vector<OwnTuple>& metrics,
                                               const py::object& motor) {
  const std::string of = py::isinstance<PyMotor>(motor) ? py::cast<const PyMotor&>(motor).name : "";
  std::vector<studies::OwnMetric> list;
  for (const auto& [name, value, gradient, unit] : metrics)
    list.push_back(to_own_metric(value, name, gradient, unit, of));
  return list;
}

studies::StudyFile read_entries(const py::dict& study, const py::object& motor,
                                const std::vector<OwnTuple>& metrics,
                                const std::vector<std::string>& settings) {
  const studies::KnownMetrics known(to_own_metrics(metrics, motor));
  const studies::Source source("study", study_text(study, motor));
  return studies::read_study(source, {}, settings);
}

std::vector<std::string> check_entries(const py::dict& study, const py::object& motor,
                                       const std::vector<OwnTuple>& metrics,
                                       const std::vector<std::string>& settings) {
  return studies::study_notes(read_entries(study, motor, metrics, settings));
}

py::tuple run_entries(const py::dict& study, const py::object& motor,
                      const std::vector<OwnTuple>& metrics, const std::string& directory,
                      const std::vector<std::string>& settings, unsigned jobs, bool fresh,
                      const py::object& progress, const py::object& stop) {
  return run(read_entries(study, motor, metrics, settings),
             {directory, jobs, fresh, progress, stop});
}

}  // namespace

void add_study(py::module_& module) {
  module.def(
      "run_file", &run_file, py::arg("path"), py::arg("directory"), py::arg("settings"),
      py::arg("jobs"), py::arg("fresh"), py::arg("progress"), py::arg("stop"),
      "run_file(path, directory, settings, jobs, fresh, progress, stop)\n--\n\nRuns a study "
      "file. Its results are kept in a directory, or, if that is empty, in memory: the content "
      "of summary.json, the words for it, the table of a run in memory, and the words as HTML.");
  module.def("kept_html", &kept_html, py::arg("directory"),
             "kept_html(directory)\n--\n\nThe answer of a result directory as HTML.");
  module.def("study_text", &study_text, py::arg("study"), py::arg("motor"),
             "study_text(study, motor)\n--\n\nThe text of a study file with the entries of a "
             "dictionary, of a Motor if `motor` is one.");
  module.def(
      "check_entries", &check_entries, py::arg("study"), py::arg("motor"), py::arg("metrics"),
      py::arg("settings"),
      "check_entries(study, motor, metrics, settings)\n--\n\nReads a study given as a dictionary, "
      "and the "
      "files that it names, without running it; an error says everything that is wrong. Notes on "
      "what was read.");
  module.def(
      "run_entries", &run_entries, py::arg("study"), py::arg("motor"), py::arg("metrics"),
      py::arg("directory"), py::arg("settings"), py::arg("jobs"), py::arg("fresh"),
      py::arg("progress"), py::arg("stop"),
      "run_entries(study, motor, metrics, directory, settings, jobs, fresh, progress, stop)\n--\n\n"
      "The same for a study file given as a dictionary, of a Motor if `motor` is one.");
}

}  // namespace twum::inline v0_1::python
