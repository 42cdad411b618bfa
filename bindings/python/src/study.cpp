// SPDX-License-Identifier: Apache-2.0
// Runs studies.
#include "conversions.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "results/answers.hpp"

#include <twum/motors/settings.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>

#include <mutex>
#include <optional>

namespace twum::python {
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

py::tuple run_file(const std::string& path, const std::string& directory,
                   const std::vector<std::string>& settings, unsigned jobs, bool fresh,
                   const py::object& progress) {
  const studies::StudyFile file = studies::read_study_file(path, settings);
  Mailbox mailbox;
  studies::RunOptions options;
  options.jobs = jobs;
  options.fresh = fresh;
  options.progress = [&](const studies::RunProgress& now) {
    mailbox.put({now.done, now.budget ? 0 : now.total, now.best});  // a budget is not a total
  };
  const studies::StudyResult result = run_interruptible(
      [&](std::stop_token stop) {
        options.stop = stop;
        return studies::run_study(file, directory, options);
      },
      [&] {
        const auto now = mailbox.take();
        if (now && !progress.is_none()) progress(now->done, now->total, now->best);
      });
  return py::make_tuple(to_python(studies::summary_value(result)), studies::summary_text(result));
}

}  // namespace

void add_study(py::module_& module) {
  module.def("run_file", &run_file, py::arg("path"), py::arg("directory"), py::arg("settings"),
             py::arg("jobs"), py::arg("fresh"), py::arg("progress"),
             "run_file(path, directory, settings, jobs, fresh, progress)\n--\n\nRuns a study file "
             "and keeps its "
             "results in a directory; the content of summary.json and the words for it.");
}

}  // namespace twum::python
