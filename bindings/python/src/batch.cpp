// SPDX-License-Identifier: Apache-2.0
// Metrics of many designs at once, and their derivatives.
#include "classes.hpp"
#include "conversions.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "tables/parameter_heading.hpp"

#include <twum/base/error.hpp>
#include <twum/base/no_value.hpp>
#include <twum/core/batch.hpp>
#include <twum/io/number.hpp>
#include <twum/io/units.hpp>
#include <twum/io/words.hpp>
#include <twum/motors/settings.hpp>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <map>
#include <set>
#include <variant>

namespace twum::inline v0_1::python {
namespace {

// A column of values of one parameter. A single value applies to every design.
struct ParameterColumn {
  Parameter parameter;
  Array values;
  bool single{false};
};

struct Designs {
  std::vector<ParameterColumn> columns;
  std::size_t rows{1};
};

bool is_single(const py::handle& value) {
  return py::isinstance<py::str>(value) || number_of(value).has_value();
}

void refuse_alternatives_together(const std::vector<ParameterColumn>& columns,
                                  const ParameterColumn& one) {
  for (const ParameterColumn& other : columns) {
    const bool same = other.parameter == one.parameter;
    if (same)
      throw InputError("designs: " + std::string(info(one.parameter).name) + " is given twice");
    if (info(one.parameter).alternative == other.parameter)
      throw InputError(std::string(info(other.parameter).name) + " and " +
                       std::string(info(one.parameter).name) +
                       " exclude each other; give one of them");
  }
}

// A column that is a parameter, by a heading such as "amplitude [um]".
struct NamedColumn {
  Parameter parameter;
  std::optional<studies::Scale> scale{};  // of a heading with a unit; nothing: SI
};

studies::Scale scale_of(const std::string& heading, std::string_view unit,
                        const ParameterInfo& row) {
  try {
    return studies::parse_unit(unit, {row.unit, row.example, row.absolute});
  } catch (const InputError& error) {
    throw InputError("column " + studies::quoted(heading) + ": " + error.what());
  }
}

// Nothing for a column that is no parameter.
std::optional<NamedColumn> named_column(const std::string& heading) {
  for (const studies::Heading& form : studies::heading_forms(heading)) {
    const auto parameter = studies::parameter_named(form.name);
    if (!parameter) continue;
    const ParameterInfo& row = info(*parameter);
    if (studies::is_bare_letter(form))
      throw InputError("column " + studies::quoted(heading) + ": " +
                       studies::bare_letter_words(form.name, row) + "; " +
                       studies::bare_letter_advice(row));
    if (!form.has_unit) return NamedColumn{*parameter};
    return NamedColumn{*parameter, scale_of(heading, form.unit, row)};
  }
  return {};
}

// A dictionary is written for this call: it has no other columns, and a letter is the symbol of a parameter.
NamedColumn typed_column(const std::string& name) {
  if (find_parameter(name)) return {studies::parse_parameter(name)};
  if (const auto named = named_column(name)) return *named;
  return {studies::parse_parameter(name)};  // throws, with the name that may be meant
}

// A number, or the text of one, in the unit of the heading; another text carries its own.
double number_in(const NamedColumn& column, py::handle entry) {
  if (!column.scale) return to_parameter_value(column.parameter, entry);
  if (const auto number = number_of(entry))
    return column.scale->read(studies::number_text(*number)).value_or(kNoValue);
  if (py::isinstance<py::str>(entry))
    if (const auto read = column.scale->read(to_text("designs", entry))) return *read;
  return to_parameter_value(column.parameter, entry);
}

// A cell without a value of a table: None, or pandas.NA.
bool is_missing(py::handle entry) {
  if (entry.is_none()) return true;
  if (PyFloat_Check(entry.ptr()) || PyLong_Check(entry.ptr()) || PyUnicode_Check(entry.ptr()))
    return false;  // quickly
  return py::cast<std::string>(py::type::of(entry).attr("__name__")) == "NAType";
}

// A list of objects, so that each entry is read in the unit of its heading.
py::object listed(const py::handle& values) {
  return py::hasattr(values, "tolist") ? py::object(values.attr("tolist")())
                                       : py::reinterpret_borrow<py::object>(values);
}

// A cell without a value makes a design without one; in a dictionary it is refused.
Array column_values(const NamedColumn& column, const py::handle& value, bool table) {
  const auto one = [&](py::handle entry) {
    return table && is_missing(entry) ? kNoValue : number_in(column, entry);
  };
  if (is_single(value)) return to_array({one(value)});
  const std::string name(info(column.parameter).name);
  const Array values = to_numbers(
      name, column.scale ? listed(value) : py::reinterpret_borrow<py::object>(value), one);
  if (values.ndim() != 1)
    throw InputError(name + ": expected one value or an array of one dimension, not " +
                     std::to_string(values.ndim()));
  return values;
}

// " (did you mean 'preload'?)" for a heading that is nearly the name of a parameter.
std::string meant(const std::string& heading) {
  std::vector<std::string_view> names;
  for (const ParameterInfo& row : parameter_table()) names.push_back(row.name);
  const auto near = studies::nearest(studies::heading_forms(heading).front().name, names);
  return near.empty() ? std::string{} : " (did you mean " + studies::quoted(near) + "?)";
}

void warn_of_unused(const std::vector<std::string>& headings) {
  if (headings.empty()) return;
  std::string text = "designs: columns that are no parameters and are not used: ";
  for (const std::string& heading : headings)
    text += (&heading == headings.data() ? "" : ", ") + studies::quoted(heading) + meant(heading);
  if (PyErr_WarnEx(PyExc_UserWarning, text.c_str(), 1) != 0) throw py::error_already_set();
}

void refuse_equal_headings(const py::object& table) {
  std::set<std::string> headings;
  for (const py::handle key : table.attr("keys")()) {
    const std::string heading = py::cast<std::string>(py::str(key));
    if (!headings.insert(heading).second)
      throw InputError("designs: two columns have the heading " + studies::quoted(heading));
  }
}

// The columns of a DataFrame or another mapping that are parameters. A dictionary has no others.
std::vector<ParameterColumn> parameter_columns(const py::object& mapping) {
  const bool dictionary = py::isinstance<py::dict>(mapping);
  if (!dictionary && (!py::hasattr(mapping, "keys") || !py::hasattr(mapping, "__getitem__")))
    throw py::type_error(
        "designs: expected a mapping of parameters to values, such as a dictionary or a "
        "DataFrame, not " +
        py::cast<std::string>(py::type::of(mapping).attr("__name__")));
  refuse_equal_headings(mapping);
  std::vector<ParameterColumn> columns;
  std::vector<std::string> unused;
  for (const py::handle key : mapping.attr("keys")()) {
    const std::string name = dictionary || PyUnicode_Check(key.ptr())
                                 ? to_text("name of a parameter", key)
                                 : py::cast<std::string>(py::str(key));
    const py::object value = mapping[key];
    // dict(frame) has columns of the frame, among which a letter may number the rows.
    const bool by_table = !dictionary || (name.size() == 1 && py::hasattr(value, "iloc"));
    const auto named = by_table ? named_column(name) : typed_column(name);
    if (!named)
      unused.push_back(name);
    else
      columns.push_back(
          {named->parameter, column_values(*named, value, !dictionary), is_single(value)});
  }
  if (columns.empty() && !unused.empty())
    throw InputError(
        "designs: no column is a parameter; name columns like 'preload [N]', or as "
        "parameter_table() lists them");
  warn_of_unused(unused);
  return columns;
}

Designs to_designs(const py::object& given) {
  Designs designs;
  bool counted = false;
  for (ParameterColumn& column : parameter_columns(given)) {
    refuse_alternatives_together(designs.columns, column);
    const bool single = column.single;
    const auto size = static_cast<std::size_t>(column.values.size());
    if (!single && counted && size != designs.rows)
      throw InputError(std::string(info(column.parameter).name) + ": " + std::to_string(size) +
                       " values, but another parameter has " + std::to_string(designs.rows));
    if (!single) designs.rows = size;
    counted = counted || !single;
    designs.columns.push_back(std::move(column));
  }
  return designs;
}

// The designs, for threads that do not hold the GIL.
class DesignRows {
 public:
  DesignRows(const MotorDesign& base, const Designs& designs) : base_(base), rows_(designs.rows) {
    for (const ParameterColumn& column : designs.columns)
      sources_.push_back(
          {column.parameter, column.values.data(), column.values.size() == 1 ? 0U : 1U});
  }

  /// Calls take(row, outcome) with the outcome of ask(motor) for every row, in their order, until a stop. Runs on several
  /// threads, without the GIL. Ctrl-C ends it.
  template <typename Ask, typename Take>
  void visit(RunningCall& call, Watch& watch, unsigned jobs, Ask ask, Take take) const {
    run_interruptible(
        call,
        [&](std::stop_token stop) {
          const auto design = [&](std::uint64_t row) { return with(base_, values(row)); };
          const auto take_all = [&](std::uint64_t first, const auto& outcomes) {
            for (std::size_t i = 0; i < outcomes.size(); ++i) take(first + i, outcomes[i]);
            watch.count(outcomes.size());
          };
          ask_designs({0, rows_, jobs, [stop] { return !stop.stop_requested(); }}, design, ask,
                      take_all);
        },
        [&] { watch.poll(call); });
  }

 private:
  struct Source {
    Parameter parameter;
    const double* data;
    std::size_t step;  // 0: one value for all
  };

  std::vector<ParameterValue> values(std::uint64_t row) const {
    std::vector<ParameterValue> values;
    for (const Source& source : sources_)
      values.emplace_back(source.parameter, source.data[row * source.step]);
    return values;
  }

  const MotorDesign& base_;
  std::size_t rows_;
  std::vector<Source> sources_;
};

// Texts as an array. Most are equal, so equal texts share one Python string.
py::object text_array(const std::vector<std::string>& texts) {
  std::map<std::string, py::str> known;
  py::list list(texts.size());
  for (std::size_t i = 0; i < texts.size(); ++i)
    list[i] = known.try_emplace(texts[i], texts[i]).first->second;
  return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = "object");
}

// --- values

std::string status_of(const std::vector<studies::MetricExpression>& metrics,
                      const std::vector<MetricValue>& values) {
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (values[k].status != MetricStatus::ok)
      return metrics[k].text + ": " + to_string(values[k].status);
  }
  return "ok";
}

// The status of designs that were not computed because of a stop.
constexpr const char* kStopped = "stopped";

py::dict evaluate_batch(const PyMotor& base, const py::object& arguments, const py::object& names,
                        unsigned jobs, const py::object& stop, const py::object& progress) {
  RunningCall call;
  const Designs designs = to_designs(arguments);
  const std::vector<studies::MetricExpression> metrics = to_metrics(names);
  py::dict answer;
  std::vector<double*> results;
  for (const studies::MetricExpression& metric : metrics) {
    Array values(static_cast<py::ssize_t>(designs.rows));
    std::fill_n(values.mutable_data(), designs.rows, kNoValue);
    results.push_back(values.mutable_data());
    answer[py::str(metric.text)] = values;
  }
  std::vector<std::string> statuses(designs.rows, kStopped);
  Watch watch(stop, progress, designs.rows);
  const studies::ExpressionEvaluator evaluator(metrics);
  DesignRows(base.motor.design(), designs)
      .visit(
          call, watch, jobs, [&](const Motor& motor) { return evaluator.evaluate(motor); },
          [&](std::size_t row, const DesignOutcome<std::vector<MetricValue>>& outcome) {
            const auto* values = std::get_if<std::vector<MetricValue>>(&outcome);
            for (std::size_t k = 0; k < results.size(); ++k)
              results[k][row] = values != nullptr ? (*values)[k].value : kNoValue;
            statuses[row] = values != nullptr ? status_of(metrics, *values)
                                              : std::get<DesignFailure>(outcome).text;
          });
  answer["status"] = text_array(statuses);
  return answer;
}

// --- derivatives

// One metric of all designs; threads fill different rows.
class DerivativeColumns {
 public:
  explicit DerivativeColumns(std::size_t rows)
      : rows_(rows),
        values_(static_cast<py::ssize_t>(rows)),
        gradient_({static_cast<py::ssize_t>(kParameterCount), static_cast<py::ssize_t>(rows)}),
        value_(values_.mutable_data()),
        entry_(gradient_.mutable_data()),
        smoothness_(rows),
        status_(rows) {
    for (std::size_t row = 0; row < rows; ++row) refuse(row, kStopped);
  }

  void set(std::size_t row, const MetricDerivative& of, const std::string& status) {
    value_[row] = of.value.value;
    for (std::size_t j = 0; j < kParameterCount; ++j) entry_[j * rows_ + row] = of.gradient[j];
    smoothness_[row] = to_string(of.smoothness);
    status_[row] = status;
  }

  void set(std::size_t row, const MetricDerivative& of) {
    set(row, of, to_string(of.value.status));
  }

  void refuse(std::size_t row, const std::string& why) {
    MetricDerivative none{{kNoValue}, {}, Smoothness::undefined};
    none.gradient.fill(kNoValue);
    set(row, none, why);
  }

  py::object to_python() const {
    py::dict gradient;
    for (const ParameterInfo& parameter : parameter_table())
      gradient[to_py(parameter.name)] = gradient_[py::int_(index_of(parameter.parameter))];
    return attribute_of_results("Derivatives")(values_, gradient, text_array(smoothness_),
                                               text_array(status_));
  }

 private:
  std::size_t rows_;
  Array values_;
  Array gradient_;  // a row for each parameter
  double* value_;
  double* entry_;
  std::vector<std::string> smoothness_;
  std::vector<std::string> status_;
};

py::dict gradients_batch(const PyMotor& base, const py::object& arguments, const py::object& names,
                         bool fixed_static_friction, unsigned jobs, const py::object& stop,
                         const py::object& progress) {
  RunningCall call;
  const Designs designs = to_designs(arguments);
  const std::vector<studies::MetricExpression> metrics = to_metrics(names);
  const studies::ExpressionEvaluator evaluator(metrics);
  std::vector<DerivativeColumns> columns;
  columns.reserve(metrics.size());
  for (std::size_t k = 0; k < metrics.size(); ++k) columns.emplace_back(designs.rows);
  Watch watch(stop, progress, designs.rows);
  DesignRows(base.motor.design(), designs)
      .visit(
          call, watch, jobs,
          [&](const Motor& motor) { return evaluator.differentiate(motor, fixed_static_friction); },
          [&](std::size_t row, const DesignOutcome<std::vector<MetricDerivative>>& outcome) {
            const auto* derivatives = std::get_if<std::vector<MetricDerivative>>(&outcome);
            for (std::size_t k = 0; k < columns.size(); ++k) {
              if (derivatives != nullptr) {
                columns[k].set(row, (*derivatives)[k]);
              } else {
                columns[k].refuse(row, std::get<DesignFailure>(outcome).text);
              }
            }
          });
  py::dict answer;
  for (std::size_t k = 0; k < metrics.size(); ++k)
    answer[py::str(metrics[k].text)] = columns[k].to_python();
  return answer;
}

}  // namespace

void add_batch(py::module_& module) {
  module.def("evaluate", &evaluate_batch, py::arg("motor"), py::arg("designs"), py::arg("metrics"),
             py::kw_only(), py::arg("jobs") = 0, py::arg("stop") = py::none(),
             py::arg("progress") = py::none(),
             "evaluate(motor, designs, metrics, *, jobs=0, stop=None, progress=None)\n--\n\n"
             "Metrics of many designs, on all processors unless `jobs` says otherwise.\n\n"
             "`designs` maps names of parameters to arrays in SI units, all of one length, or to "
             "single values,\n"
             "which may have a unit; the rest is the motor's. Names may have a unit, such as "
             "'amplitude [um]'. A\n"
             "DataFrame may have other columns, of which a warning tells, and cells without a "
             "value. The answer maps each "
             "metric to an "
             "array, and 'status'\n"
             "to 'ok' or why a design has no full answer: its metrics are NaN then. The numbers do "
             "not depend on\n"
             "`jobs`. Other Python threads run meanwhile, and Ctrl-C ends it. `stop`, such as a "
             "threading.Event,\n"
             "ends it too: designs that were not computed have the status 'stopped'. `progress` is "
             "told the\n"
             "designs so far and their number, as progress(done, total, '').");
  module.def("gradients", &gradients_batch, py::arg("motor"), py::arg("designs"),
             py::arg("metrics"), py::kw_only(), py::arg("fixed_static_friction") = false,
             py::arg("jobs") = 0, py::arg("stop") = py::none(), py::arg("progress") = py::none(),
             "gradients(motor, designs, metrics, *, fixed_static_friction=False, jobs=0, "
             "stop=None, progress=None)\n--\n\n"
             "Metrics of many designs with exact derivatives with respect to every parameter: "
             "Motor.gradients() for\n"
             "the designs that evaluate() takes. The answer maps each metric to its Derivatives, "
             "arrays over the\n"
             "designs: gradients(motor, {'preload': loads}, "
             "'stall_torque')['stall_torque']['thickness'].\n"
             "About twice the time of evaluate(), for one derivative as for all. Other Python "
             "threads run meanwhile,\n"
             "and Ctrl-C ends it. `stop` and `progress` are those of evaluate().");
}

}  // namespace twum::inline v0_1::python
