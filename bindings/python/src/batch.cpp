// SPDX-License-Identifier: Apache-2.0
// Metrics of many designs at once.
#include "conversions.hpp"
#include "parts.hpp"
#include "py_motor.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/motor/settings.hpp>
#include <twum/studies/run/ordered.hpp>

#include <algorithm>
#include <cstddef>
#include <map>
#include <optional>

namespace twum::python {
namespace {

// Enough designs a block that handing one out costs nothing beside it.
constexpr std::size_t kBlock = 256;

// A column of values of one parameter; one value holds for every design.
struct Column {
  Parameter parameter;
  Array values;
};

struct Designs {
  std::vector<Column> columns;
  std::size_t rows{1};
};

struct Block {
  std::size_t begin{0};
  std::size_t end{0};
};

Array column_values(Parameter parameter, const py::handle& value) {
  if (py::isinstance<py::str>(value) || number_of(value))
    return to_array({to_parameter_value(parameter, value)});
  const Array values = Array::ensure(py::reinterpret_borrow<py::object>(value));
  if (!values) throw py::error_already_set();
  if (values.ndim() != 1)
    throw InputError(std::string(info(parameter).name) +
                     ": expected one value or an array of one dimension");
  return values;
}

void refuse_twins(const std::vector<Column>& columns, const Column& one) {
  for (const Column& other : columns) {
    const bool same = other.parameter == one.parameter;
    if (same || info(one.parameter).twin == other.parameter)
      throw InputError(std::string(info(other.parameter).name) + " and " +
                       std::string(info(one.parameter).name) + " say the same; give one of them");
  }
}

Designs to_designs(const py::dict& arguments) {
  Designs designs;
  bool counted = false;
  for (const auto& [key, value] : arguments) {
    const Parameter parameter = studies::parse_parameter(py::cast<std::string>(key));
    Column column{parameter, column_values(parameter, value)};
    refuse_twins(designs.columns, column);
    const bool single = py::isinstance<py::str>(value) || number_of(value);
    const auto size = static_cast<std::size_t>(column.values.size());
    if (!single && counted && size != designs.rows)
      throw InputError(std::string(info(parameter).name) + ": " + std::to_string(size) +
                       " values, but another parameter has " + std::to_string(designs.rows));
    if (!single) designs.rows = size;
    counted = counted || !single;
    designs.columns.push_back(std::move(column));
  }
  return designs;
}

// What a block needs besides its designs; shared by all threads, none of it Python's.
class Evaluation {
 public:
  Evaluation(const MotorDesign& base, const Designs& designs,
             const std::vector<studies::MetricExpression>& metrics, std::vector<double*> results)
      : base_(base), metrics_(metrics), evaluator_(metrics), results_(std::move(results)) {
    for (const Column& column : designs.columns) {
      parameters_.emplace_back(column.parameter, 0.0);
      from_.push_back({column.values.data(), column.values.size() == 1 ? 0U : 1U});
    }
    statuses_.resize(designs.rows);
  }

  void run(const Block& block) {
    std::vector<ParameterValue> values = parameters_;
    std::vector<MetricValue> answers(metrics_.size());
    for (std::size_t row = block.begin; row < block.end; ++row) {
      for (std::size_t j = 0; j < values.size(); ++j)
        values[j].second = from_[j].data[row * from_[j].step];
      statuses_[row] = evaluate(values, answers);
      for (std::size_t k = 0; k < answers.size(); ++k) results_[k][row] = answers[k].value;
    }
  }

  const std::vector<std::string>& statuses() const { return statuses_; }

 private:
  struct Source {
    const double* data;
    std::size_t step;  // 0: one value for all
  };

  std::string evaluate(const std::vector<ParameterValue>& values,
                       std::vector<MetricValue>& answers) const {
    std::optional<Motor> motor;
    try {
      motor.emplace(with(base_, values));
    } catch (const InputError& error) {
      std::fill(answers.begin(), answers.end(),
                MetricValue{std::numeric_limits<double>::quiet_NaN()});
      return error.what();
    }
    evaluator_.evaluate(*motor, answers);
    for (std::size_t k = 0; k < answers.size(); ++k) {
      if (answers[k].status != MetricStatus::ok)
        return metrics_[k].text + ": " + to_string(answers[k].status);
    }
    return {};
  }

  const MotorDesign& base_;
  const std::vector<studies::MetricExpression>& metrics_;
  studies::ExpressionEvaluator evaluator_;
  std::vector<double*> results_;
  std::vector<ParameterValue> parameters_;
  std::vector<Source> from_;
  std::vector<std::string> statuses_;  // empty: ok
};

// Most statuses are the same few: each text becomes one Python string.
py::object status_array(const std::vector<std::string>& statuses) {
  std::map<std::string, py::str> texts;
  py::list list(statuses.size());
  for (std::size_t i = 0; i < statuses.size(); ++i) {
    const std::string& text = statuses[i].empty() ? "ok" : statuses[i];
    list[i] = texts.try_emplace(text, text).first->second;
  }
  return py::module_::import("numpy").attr("array")(list, py::arg("dtype") = "object");
}

py::dict evaluate_batch(const PyMotor& motor, const py::dict& arguments, const py::object& names,
                        unsigned jobs) {
  const Designs designs = to_designs(arguments);
  const std::vector<studies::MetricExpression> metrics = to_metrics(names);
  py::dict answer;
  std::vector<double*> results;
  for (const studies::MetricExpression& metric : metrics) {
    Array values(static_cast<py::ssize_t>(designs.rows));
    results.push_back(values.mutable_data());
    answer[py::str(metric.text)] = values;
  }
  Evaluation evaluation(motor.motor.design(), designs, metrics, std::move(results));
  {
    const py::gil_scoped_release release;
    std::size_t next = 0;
    const auto read = [&](Block& block) {
      block = {next, std::min(next + kBlock, designs.rows)};
      next = block.end;
      return block.begin < block.end;
    };
    studies::run_ordered<Block>(
        studies::job_count(jobs), read, [&](Block& block) { evaluation.run(block); },
        [](Block&) {});
  }
  answer["status"] = status_array(evaluation.statuses());
  return answer;
}

}  // namespace

void add_batch(py::module_& module) {
  module.def("evaluate", &evaluate_batch, py::arg("motor"), py::arg("designs"), py::arg("metrics"),
             py::kw_only(), py::arg("jobs") = 0,
             "evaluate(motor, designs, metrics, *, jobs=0)\n--\n\n"
             "Metrics of many designs, on all processors unless `jobs` says otherwise.\n\n"
             "`designs` maps names of parameters to arrays in SI units, all of one length, or to "
             "single values,\n"
             "which may have a unit; the rest is the motor's. The answer maps each metric to an "
             "array, and 'status'\n"
             "to 'ok' or why a design has no full answer: its metrics are NaN then. The numbers do "
             "not depend on\n"
             "`jobs`. Other Python threads run meanwhile.");
}

}  // namespace twum::python
