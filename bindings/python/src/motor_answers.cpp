// SPDX-License-Identifier: Apache-2.0
// What a motor answers: metrics with derivatives, operating points, curves and fields.
#include "motor_answers.hpp"

#include "conversions.hpp"

#include <twum/base/error.hpp>
#include <twum/io/words.hpp>
#include <twum/motion/manoeuvres.hpp>  // gives the program metrics of motions
#include <twum/motors/curve_points.hpp>

#include <limits>
#include <optional>

namespace twum::inline v0_1::python {
namespace {

using Class = py::class_<PyMotor, std::shared_ptr<PyMotor>>;

std::string metric_doc(const MetricInfo& row) {
  std::string doc = std::string(row.text) + " [" + std::string(row.unit) + "].";
  doc.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(doc.front())));
  return doc;
}

// --- metrics by expression

std::vector<studies::MetricExpression> asked(const PyMotor& self, const py::args& metrics) {
  if (metrics.empty()) return studies::plain_metrics(self.motor.design());
  return metrics.size() == 1 ? to_metrics(metrics[0]) : to_metrics(metrics);
}

std::vector<MetricValue> values_of(const PyMotor& self,
                                   const std::vector<studies::MetricExpression>& metrics) {
  std::vector<MetricValue> values(metrics.size());
  const py::gil_scoped_release release;
  studies::ExpressionEvaluator(metrics).evaluate(self.motor, values);
  return values;
}

py::dict metrics_of(const PyMotor& self, const py::args& names) {
  const auto metrics = asked(self, names);
  const std::vector<MetricValue> values = values_of(self, metrics);
  py::dict answer;
  for (std::size_t i = 0; i < metrics.size(); ++i)
    answer[py::str(metrics[i].text)] = values[i].value;
  return answer;
}

py::dict statuses_of(const PyMotor& self, const py::args& names) {
  const auto metrics = asked(self, names);
  const std::vector<MetricValue> values = values_of(self, metrics);
  py::dict answer;
  for (std::size_t i = 0; i < metrics.size(); ++i)
    answer[py::str(metrics[i].text)] = to_string(values[i].status);
  return answer;
}

py::dict gradients_of(const PyMotor& self, const py::args& names, bool fixed_static_friction) {
  const auto metrics = asked(self, names);
  std::vector<MetricDerivative> derivatives;
  {
    const py::gil_scoped_release release;
    derivatives =
        studies::ExpressionEvaluator(metrics).differentiate(self.motor, fixed_static_friction);
  }
  py::dict answer;
  for (std::size_t i = 0; i < metrics.size(); ++i)
    answer[py::str(metrics[i].text)] = PyDerivative{derivatives[i]};
  return answer;
}

// --- metrics as attributes and methods

void add_plain_metric(Class& motor, const MetricInfo& row) {
  motor.def_property_readonly(
      std::string(row.name).c_str(),
      [&row](const PyMotor& self) {
        return value_or_throw(row.name, evaluate(self.motor, {row.metric}));
      },
      metric_doc(row).c_str());
}

// One request for each number of an array; NaN where there is no answer.
Array evaluate_array(const PyMotor& self, MetricRequest request, const Array& points) {
  Array values(std::vector<py::ssize_t>(points.shape(), points.shape() + points.ndim()));
  const double* from = points.data();
  double* to = values.mutable_data();
  const py::ssize_t count = points.size();
  const py::gil_scoped_release release;
  for (py::ssize_t i = 0; i < count; ++i) {
    request.at = from[i];
    to[i] = evaluate(self.motor, request).value;
  }
  return values;
}

// How Python names what a metric is asked at, with its unit and an example.
struct Point {
  const char* name;
  const char* unit;
  const char* example;
};
Point point_of(Argument argument) {
  switch (argument) {
    case Argument::torque: return {"torque", "N.m", "0.5 N.m"};
    case Argument::angle: return {"angle", "rad", "90 deg"};
    case Argument::periods: return {"periods", "1", "32"};
    default: return {"speed", "rad/s", "100 rpm"};
  }
}

Array to_points(const std::string& name, Argument argument, const py::object& at) {
  const Point point = point_of(argument);
  const auto one = [&](py::handle entry) {
    return to_quantity(name, entry, point.unit, point.example);
  };
  return to_numbers(name, at, one);
}

double point_value(const PyMotor& self, std::string_view name, const MetricRequest& request) {
  const MetricValue value = evaluate(self.motor, request);
  // A speed out of range is the caller's mistake: operating_point() throws the InputError that says what is right.
  if (value.status == MetricStatus::out_of_range) self.motor.operating_point(request.at);
  return value_or_throw(name, value);
}

py::object point_metric(const PyMotor& self, const MetricInfo& row, Argument argument,
                        const py::object& at) {
  const std::string name(row.name);
  if (py::isinstance<py::str>(at)) {
    const auto metric = studies::parse_metric(name + "(" + to_text(name, at) + ")");
    return py::float_(point_value(self, metric.text, *metric.request()));
  }
  MetricRequest request{row.metric, argument, 0};
  const auto number = number_of(at);
  if (!number) return evaluate_array(self, request, to_points(name, argument, at));
  request.at = *number;
  return py::float_(point_value(self, name, request));
}

// Where the drive holds a torque at a speed.
py::object held_metric(const PyMotor& self, const MetricInfo& row, const py::object& torque,
                       const py::object& speed) {
  const std::string name(row.name);
  const MetricRequest request{row.metric, Argument::both,
                              to_quantity(name, speed, "rad/s", "100 rpm"),
                              to_quantity(name, torque, "N.m", "0.5 N.m")};
  return py::float_(value_or_throw(name, evaluate(self.motor, request)));
}

void add_held_metric(Class& motor, const MetricInfo& row) {
  const std::string name(row.name);
  motor.def(
      name.c_str(),
      [&row](const PyMotor& self, const py::object& torque, const py::object& speed) {
        return held_metric(self, row, torque, speed);
      },
      py::arg("torque"), py::arg("speed"),
      (name + "(self, torque, speed)\n--\n\n" + metric_doc(row) +
       "\n\nA torque [N.m] and a speed [rad/s], as numbers or texts.")
          .c_str());
}

void add_point_metric(Class& motor, const MetricInfo& row) {
  if (row.argument == Argument::both) return add_held_metric(motor, row);
  const std::string name(row.name);
  const std::string doc_of_array =
      "An array of numbers gives an array, NaN where there is no answer.";
  const bool follows = row.argument == Argument::speed_or_torque;
  if (!follows && row.argument != Argument::either) {
    const Point point = point_of(row.argument);
    const std::string what = point.name, unit = point.unit;
    motor.def(
        name.c_str(),
        [&row](const PyMotor& self, const py::object& at) {
          return point_metric(self, row, row.argument, at);
        },
        py::arg(what.c_str()),
        (name + "(self, " + what + ")\n--\n\n" + metric_doc(row) +
         (unit == "1" ? "\n\n" : "\n\nA number is in " + unit + ". ") + doc_of_array)
            .c_str());
    return;
  }
  motor.def(
      name.c_str(),
      [&row, follows](const PyMotor& self, const py::object& speed, const py::object& torque) {
        const bool neither = speed.is_none() && torque.is_none(),
                   both = !speed.is_none() && !torque.is_none();
        if (neither || (both && !follows))
          throw InputError(std::string(row.name) + (follows
                                                        ? ": give a speed, a torque, or both"
                                                        : ": give a speed or a torque, not both"));
        if (both) return held_metric(self, row, torque, speed);
        return speed.is_none() ? point_metric(self, row, Argument::torque, torque)
                               : point_metric(self, row, Argument::speed, speed);
      },
      py::arg("speed") = py::none(), py::kw_only(), py::arg("torque") = py::none(),
      (name + "(self, speed=None, *, torque=None)\n--\n\n" + metric_doc(row) +
       "\n\nAt a speed [rad/s] or a torque [N.m]; of a text the unit tells which. " +
       (follows ? "At both the drive follows. " : "") + doc_of_array)
          .c_str());
}

// --- points, curves, fields

py::list zones_list(const std::vector<Zone>& zones) {
  py::list list;
  for (const Zone& zone : zones)
    list.append(py::make_tuple(to_string(zone.state), zone.from, zone.to));
  return list;
}

py::object curve_of(const py::object& self, const py::object& speeds, std::size_t points) {
  const Motor& motor = py::cast<const PyMotor&>(self).motor;
  if (speeds.is_none() && points < 2) throw InputError("points: expected at least 2");
  const std::vector<double> at =
      speeds.is_none() ? studies::curve_speeds(motor, points) : to_speeds(speeds);
  std::vector<OperatingPoint> curve;
  {
    const py::gil_scoped_release release;
    curve = torque_speed_curve(motor, at);
  }
  py::dict columns;
  for (const studies::CurveColumn& column : studies::curve_columns(motor.design())) {
    std::vector<double> values;
    for (const OperatingPoint& point : curve) values.push_back(column.value(point));
    columns[column.name] = to_array(values);
  }
  py::list statuses;
  for (const OperatingPoint& point : curve) statuses.append(to_string(point.status));
  columns["status"] = statuses;
  return attribute_of_results("Curve")(self, **columns);
}

// True, False or None for each speed.
py::list squeals_of(const PyMotor& self, const py::object& speeds) {
  const std::vector<double> at = to_speeds(speeds);
  std::vector<std::optional<bool>> found;
  {
    const py::gil_scoped_release release;
    for (const double speed : at)
      found.push_back(studies::squeals(self.motor.design(), self.motor.backward_wave(speed)));
  }
  py::list list;
  for (const std::optional<bool>& one : found)
    list.append(one ? py::object(py::bool_(*one)) : py::object(py::none()));
  return list;
}

py::object fields_of(const py::object& self, const py::object& speed, int samples) {
  const Motor& motor = py::cast<const PyMotor&>(self).motor;
  const ContactFields fields = motor.fields(to_speed(speed), samples);
  if (fields.point.status != PointStatus::ok) {
    const std::string reason = to_string(fields.point.status);
    throw EvaluationError(reason, "fields: the motor has no answer at this speed: " + reason);
  }
  const auto column = [&](double FieldSample::*member) {
    std::vector<double> values;
    for (const FieldSample& sample : fields.samples) values.push_back(sample.*member);
    return to_array(values);
  };
  py::dict columns;
  columns["phase"] = column(&FieldSample::phase);
  columns["pressure"] = column(&FieldSample::pressure);
  columns["traction"] = column(&FieldSample::traction);
  columns["displacement"] = column(&FieldSample::displacement);
  columns["stator_velocity"] = column(&FieldSample::stator_velocity);
  columns["layer_velocity"] = column(&FieldSample::layer_velocity);
  columns["radial_velocity"] = column(&FieldSample::radial_velocity);
  columns["radial_traction"] = column(&FieldSample::radial_traction);
  columns["zones"] = zones_list(fields.zones);
  return attribute_of_results("Fields")(self, fields.point, **columns);
}

}  // namespace

void add_answers(Class& motor) {
  for (const MetricInfo& row : metric_table()) {
    if (row.argument == Argument::none)
      add_plain_metric(motor, row);
    else
      add_point_metric(motor, row);
  }
  motor.def("metrics", &metrics_of,
            "metrics(self, *metrics)\n--\n\nValues of metrics such as 'stall_torque' or "
            "'torque_at(100 rpm)' by "
            "name, SI; those\nwithout argument if none is named. NaN where there is none: status() "
            "says why. "
            "Work\nthat several share is done once.");
  motor.def("status", &statuses_of,
            "status(self, *metrics)\n--\n\n'ok' for each metric, or the short reason why it has "
            "no value.");
  motor.def(
      "gradients", &gradients_of, py::kw_only(), py::arg("fixed_static_friction") = false,
      "gradients(self, *metrics, fixed_static_friction=False)\n--\n\nMetrics with exact "
      "derivatives, a "
      "Derivative each. The static friction moves along with\nthe kinetic one unless it is held.");
  motor.def(
      "point",
      [](const PyMotor& self, const py::object& speed) {
        return self.motor.operating_point(to_speed(speed));
      },
      py::arg("speed"),
      "point(self, speed)\n--\n\nOperating point at a rotor speed: a number in rad/s, or a text "
      "such as '100 "
      "rpm'.");
  motor.def("curve", &curve_of, py::arg("speeds") = py::none(), py::kw_only(),
            py::arg("points") = 51,
            "curve(self, speeds=None, *, points=51)\n--\n\nTorque-speed curve: at the speeds "
            "given, or from rest "
            "to a little beyond no-load.");
  motor.def("_squeals", &squeals_of, py::arg("speeds"));  // for Curve.squeals
  motor.def("fields", &fields_of, py::arg("speed"), py::arg("samples") = 400,
            "fields(self, speed, samples=400)\n--\n\nPressure, traction, displacement and "
            "velocities along one "
            "wave, and its zones.");
}

}  // namespace twum::inline v0_1::python
