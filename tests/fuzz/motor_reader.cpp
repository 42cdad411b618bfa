// SPDX-License-Identifier: Apache-2.0
#include "fuzz/readers.hpp"
#include "fuzz/targets.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/motor_file.hpp>

#include <cmath>

namespace twum::fuzz {
namespace {

using namespace twum::studies;

// SI values are written to the last digit, so that reading them back gives the same number.
void expect_same(const MotorFile& motor) {
  const MotorFile again = read_motor(Source("again.yaml", motor_text(motor)));
  for (const ParameterInfo& row : parameter_table()) {
    const Parameter parameter = row.parameter;
    if (in_use(again.design, parameter) != in_use(motor.design, parameter) ||
        (in_use(motor.design, parameter) &&
         get(again.design, parameter) != get(motor.design, parameter)))
      throw BrokenLaw("read back differently: " + std::string(row.name));
  }
}

void expect_metrics(const MotorFile& file) {
  const auto metrics = plain_metrics(file.design);
  std::vector<MetricValue> values(metrics.size());
  ExpressionEvaluator(metrics).evaluate(Motor(file.design), values);
  for (std::size_t i = 0; i < metrics.size(); ++i) {
    if (values[i].status == MetricStatus::ok && !std::isfinite(values[i].value))
      throw BrokenLaw("not finite: " + metrics[i].text);
  }
}

}  // namespace

void feed_motor(std::string_view text) {
  MotorFile motor;
  try {
    motor = read_motor(Source("motor.yaml", std::string(text)));
  } catch (const FileError&) {
    return;
  }
  expect_same(motor);
  expect_metrics(motor);
}

}  // namespace twum::fuzz
