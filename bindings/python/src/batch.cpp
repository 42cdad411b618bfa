// SPDX-License-Identifier: Apache-2.0
// Metrics of many designs at once, and their derivatives.
#include "conversions.hpp"
#include "interruptible.hpp"
#include "parts.hpp"
#include "py_motor.hpp"

#include <twum/base/error.hpp>
#include <twum/studies/jobs/ordered.hpp>
#include <twum/studies/motor/settings.hpp>

#include <algorithm>
#include <cstddef>
#include <limits>
#include <map>
#include <optional>

namespace twum::python {
namespace {

// Enough designs a block that handing one out costs nothing beside it.
constexpr std::size_t kBlock = 256;
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

// A column of values of one parameter; one value holds for every design.
struct Column {
  Parameter parameter;
  Array values;
};

struct Designs {
  std::vector<Column> columns;
  std::size_t rows{1};
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

// The designs as motors, for threads that know nothing of Python.
class MotorRows {
 public:
  MotorRows(const MotorDesign& base, const Designs& designs) : base_(base), rows_(designs.rows) {
    for (const Column& column : designs.columns) {
      parameters_.emplace_back(column.parameter, 0.0);
      from_.push_back({column.values.data(), column.values.size() == 1 ? 0U : 1U});
    }
  }

  /// Calls answer(row, motor, why) for every row, on several threads and without the GIL; the motor is
  /// null where a design cannot be, and `why` says why then. Ctrl-C ends it.
  template <typename Answer>
  void visit(unsigned jobs, Answer answer) const {
    run_interruptible(
        [&](std::stop_token stop) {
          std::size_t next = 0;
          const auto read = [&](Block& block) {
            block = {next, std::min(next + kBlock, rows_)};
            next = block.end;
            return block.begin < block.end && !stop.stop_requested();
          };
          const auto work = [&](Block& block) { visit_block(block, answer); };
          studies::run_ordered<Block>(studies::job_count(jobs), read, work, [](Block&) {});
        },
        [] {});
  }

 private:
  struct Block {
    std::size_t begin{0};
    std::size_t end{0};
  };
  struct Source {
    const double* data;
    std::size_t step;  // 0: one value for all
  };

  template <typename Answer>
  void visit_block(const Block& block, Answer& answer) const {
    std::vector<ParameterValue> values = parameters_;
    for (std::size_t row = block.begin; row < block.end; ++row) {
      for (std::size_t j = 0; j < values.size(); ++j)
        values[j].second = from_[j].data[row * from_[j].step];
      std::optional<Motor> motor;
      std::string why;
      try {
        motor.emplace(with(base_, values));
      } catch (const InputError& error) {
        why = error.what();
      }
      answer(row, motor ? &*motor : nullptr, why);
    }
  }

  const MotorDesign& base_;
  std::size_t rows_;
  std::vector<ParameterValue> parameters_;
  std::vector<Source> from_;
};

// Texts as an array. Most are the same few: each becomes one Python string.
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

py::dict evaluate_batch(const PyMotor& base, const py::dict& arguments, const py::object& names,
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
  std::vector<std::string> statuses(designs.rows);
  const studies::ExpressionEvaluator evaluator(metrics);
  MotorRows(base.motor.design(), designs)
      .visit(jobs, [&](std::size_t row, const Motor* motor, const std::string& why) {
        std::vector<MetricValue> values(metrics.size(), MetricValue{kNaN});
        if (motor != nullptr) evaluator.evaluate(*motor, values);
        for (std::size_t k = 0; k < values.size(); ++k) results[k][row] = values[k].value;
        statuses[row] = motor != nullptr ? status_of(metrics, values) : why;
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
        status_(rows) {}

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
    MetricDerivative none{{kNaN}, {}, Smoothness::undefined};
    none.gradient.fill(kNaN);
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

py::dict gradients_batch(const PyMotor& base, const py::dict& arguments, const py::object& names,
                         bool fixed_static_friction, unsigned jobs) {
  const Designs designs = to_designs(arguments);
  const std::vector<studies::MetricExpression> metrics = to_metrics(names);
  const studies::ExpressionEvaluator evaluator(metrics);
  std::vector<DerivativeColumns> columns;
  columns.reserve(metrics.size());
  for (std::size_t k = 0; k < metrics.size(); ++k) columns.emplace_back(designs.rows);
  MotorRows(base.motor.design(), designs)
      .visit(jobs, [&](std::size_t row, const Motor* motor, const std::string& why) {
        if (motor == nullptr) {
          for (DerivativeColumns& column : columns) column.refuse(row, why);
          return;
        }
        const auto derivatives = evaluator.differentiate(*motor, fixed_static_friction);
        for (std::size_t k = 0; k < columns.size(); ++k) columns[k].set(row, derivatives[k]);
      });
  py::dict answer;
  for (std::size_t k = 0; k < metrics.size(); ++k)
    answer[py::str(metrics[k].text)] = columns[k].to_python();
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
             "`jobs`. Other Python threads run meanwhile, and Ctrl-C ends it.");
  module.def("gradients", &gradients_batch, py::arg("motor"), py::arg("designs"),
             py::arg("metrics"), py::kw_only(), py::arg("fixed_static_friction") = false,
             py::arg("jobs") = 0,
             "gradients(motor, designs, metrics, *, fixed_static_friction=False, jobs=0)\n--\n\n"
             "Metrics of many designs with exact derivatives with respect to every parameter: "
             "Motor.gradients() for\n"
             "the designs that evaluate() takes. The answer maps each metric to its Derivatives, "
             "arrays over the\n"
             "designs: gradients(motor, {'preload': loads}, "
             "'stall_torque')['stall_torque']['thickness'].\n"
             "About twice the time of evaluate(), for one derivative as for all. Other Python "
             "threads run meanwhile,\n"
             "and Ctrl-C ends it.");
}

}  // namespace twum::python
