// SPDX-License-Identifier: Apache-2.0
#include "metrics/own_metric.hpp"

#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace twum::inline v0_1::motors {
namespace {

constexpr Expected kSpeed{"rad/s", "100 rpm"};
constexpr Expected kTorque{"N.m", "0.5 N.m"};
constexpr Expected kAngle{"rad", "90 deg"};
constexpr Expected kPeriods{"1", "32"};
constexpr Expected kTime{"s", "10 min"};

// "torque_at(100 rpm)": how a point metric is written.
// What a metric may be asked at; the first is the example.
std::vector<Expected> expected_of(Argument argument) {
  switch (argument) {
    case Argument::torque: return {kTorque};
    case Argument::angle: return {kAngle};
    case Argument::periods: return {kPeriods};
    case Argument::speed: return {kSpeed};
    default: return {kSpeed, kTorque};
  }
}

std::string usage(const MetricInfo& metric) {
  if (metric.argument == Argument::both) return std::string(metric.name) + "(0.5 N.m, 100 rpm)";
  return std::string(metric.name) + "(" +
         std::string(expected_of(metric.argument).front().example) + ")";
}

const char* argument_phrase(Argument argument) {
  switch (argument) {
    case Argument::both: return "a torque and a speed";
    case Argument::speed: return "a speed";
    case Argument::torque: return "a torque";
    case Argument::angle: return "an angle of more than 0 rad";
    case Argument::periods: return "a number of periods of at least 1";
    default: return "a speed or a torque";
  }
}

[[noreturn]] void unknown_name(std::string_view name, std::size_t at) {
  std::vector<std::string_view> names;
  for (const MetricInfo& row : metric_table()) names.push_back(row.name);
  const bool is_near_metric = !nearest(name, names).empty();
  if (!is_near_metric) {
    for (const ParameterInfo& row : parameter_table()) names.push_back(row.name);
    for (const OwnTerm& own : known_metrics()) names.push_back(own->name);
  }
  const std::string remedy =
      nearest(name, names).empty()
          ? "'twum metrics' lists the metrics, 'twum parameters' the parameters"
          : did_you_mean(name, names);
  throw ValueError("unknown metric " + quoted(name), remedy, at);
}

// A move goes forward, and a burst has a period.
void require_way(Argument kind, double value) {
  if (kind == Argument::angle && !(value > 0))
    throw ValueError("an angle of 0 or less", "give an angle such as '90 deg'", 0);
  if (kind == Argument::periods && !(value >= 1))
    throw ValueError("less than one period", "give a number of periods such as '32'", 0);
}

// The text between the parentheses, as a request.
MetricRequest parse_argument(const MetricInfo& metric, std::string_view argument, std::size_t at) {
  const std::vector<Expected> expected = expected_of(metric.argument);
  try {
    const Quantity quantity = parse_quantity(argument, expected);
    const Argument kind = expected[quantity.which].unit == kSpeed.unit    ? Argument::speed
                          : expected[quantity.which].unit == kTorque.unit ? Argument::torque
                                                                          : metric.argument;
    require_way(kind, quantity.value);
    return {metric.metric, kind, quantity.value};
  } catch (const ValueError& error) {
    const char* time = metric.timed ? ", or after it a time [s] such as '10 min'" : "";
    throw ValueError(std::string(metric.name) + ": " + error.found(), error.expected() + time,
                     at + error.position());
  }
}

// "0.5 N.m, 100 rpm" in either order: the drive holds the torque at the speed.
MetricRequest parse_held(const MetricInfo& metric, std::string_view first, std::string_view second,
                         std::string_view text) {
  if (metric.argument != Argument::both && metric.argument != Argument::speed_or_torque)
    throw ValueError(
        std::string(metric.name) + " takes " + argument_phrase(metric.argument) + " alone",
        "write '" + usage(metric) + "'", static_cast<std::size_t>(second.data() - text.data()));
  const auto at = [&](std::string_view piece) {
    return static_cast<std::size_t>(piece.data() - text.data());
  };
  MetricInfo either = metric;
  either.argument = Argument::speed_or_torque;
  const MetricRequest a = parse_argument(either, first, at(first)),
                      b = parse_argument(either, second, at(second));
  if (a.argument == b.argument)
    throw ValueError(std::string(metric.name) + " takes one torque and one speed, but both are " +
                         (a.argument == Argument::speed ? "speeds" : "torques"),
                     "write '" + std::string(metric.name) + "(0.5 N.m, 100 rpm)'", at(second));
  const bool speed_first = a.argument == Argument::speed;
  if (!((speed_first ? a.at : b.at) > 0))
    throw ValueError(
        std::string(metric.name) + ": a drive holds a torque at a speed of more than 0 rpm",
        "at rest friction holds it without a wave; give a speed such as '100 rpm'",
        at(speed_first ? first : second));
  return {metric.metric, Argument::both, speed_first ? a.at : b.at, speed_first ? b.at : a.at};
}

// Takes the time after which a temperature is asked for out of the list: "0.5 N.m, 10 min".
std::optional<double> take_time(const MetricInfo& metric, std::vector<std::string_view>& pieces,
                                std::string_view text) {
  if (!metric.timed) return {};
  for (auto piece = pieces.begin(); piece != pieces.end(); ++piece) {
    Quantity quantity;
    try {
      quantity = parse_quantity(*piece, std::vector{kSpeed, kTorque, kTime});
    } catch (const ValueError&) {
      continue;  // it is read again
    }
    if (quantity.which != 2) continue;
    if (!(quantity.value >= 0))
      throw ValueError(std::string(metric.name) + ": a time below 0",
                       "give a time such as '10 min', or leave it out for the steady temperature",
                       static_cast<std::size_t>(piece->data() - text.data()));
    pieces.erase(piece);
    return quantity.value;
  }
  return {};
}

// Reads "torque_at(100 rpm)"; the formula reader has checked the parentheses.
MetricRequest parse_request(const MetricInfo& metric, std::string_view text, std::size_t open) {
  if (open == std::string_view::npos) {
    if (metric.argument != Argument::none) {
      throw ValueError(quoted(text) + " needs " + argument_phrase(metric.argument),
                       "expected one such as '" + usage(metric) + "'", text.size());
    }
    return {metric.metric, Argument::none, 0};
  }
  if (metric.argument == Argument::none) {
    throw ValueError(quoted(metric.name) + " takes nothing in parentheses",
                     "write it without parentheses", open);
  }
  const std::string_view argument = trimmed(text.substr(open + 1, text.size() - open - 2));
  std::vector<std::string_view> pieces = split_list(argument);
  const std::optional<double> after = take_time(metric, pieces, text);
  const bool held =
      metric.argument == Argument::both || metric.argument == Argument::speed_or_torque;
  if (pieces.size() > 2 && held)
    throw ValueError(std::string(metric.name) + " takes " +
                         (metric.timed ? "a torque, a speed and a time at most"
                                       : "a torque and a speed at most"),
                     "write '" + usage(metric) + "'",
                     static_cast<std::size_t>(pieces[2].data() - text.data()));
  if (pieces.empty() || (pieces.size() == 1 && metric.argument == Argument::both))
    throw ValueError(quoted(text) + " needs " + argument_phrase(metric.argument),
                     "expected one such as '" + usage(metric) + "'", text.size());
  const auto at = static_cast<std::size_t>(pieces.front().data() - text.data());
  MetricRequest request = pieces.size() >= 2 ? parse_held(metric, pieces[0], pieces[1], text)
                                             : parse_argument(metric, pieces[0], at);
  request.after = after;
  return request;
}

// Refuses a symbol in a formula, where it could be a unit.
void refuse_symbol(const ParameterInfo& row, std::string_view name) {
  if (row.name == name) return;
  throw ValueError(quoted(name) + " is a symbol, which an expression does not read",
                   "write '" + std::string(row.name) +
                       "'; a unit is written without blanks, such as '5 kW/m^2'");
}

// warm() and worn(): another metric of the motor after a time under a load.
struct Aged {
  std::string_view name;
  const char* usage;
  bool (*refuses)(const MetricInfo&);  // metrics that are about this themselves
  std::optional<LoadPoint> MetricRequest::*load;
};
constexpr std::array kAged{
    Aged{"warm",
         "write 'warm(speed_at(0.5 N.m))', 'warm(stall_torque, 0.5 N.m)' for the temperatures of a "
         "point, or 'warm(stall_torque)' for those of the motor's operation",
         [](const MetricInfo& row) { return row.needs_thermal || row.needs_wear; },
         &MetricRequest::warm_at},
    Aged{"worn",
         "write 'worn(speed_at(0.5 N.m))' for the end of the life in the motor's operation, or "
         "'worn(stall_torque, 0.5 N.m)' for that under a load that stays",
         [](const MetricInfo& row) { return row.needs_wear; }, &MetricRequest::worn_at}};

const Aged* find_aged(std::string_view name) {
  const auto* found =
      std::find_if(kAged.begin(), kAged.end(), [&](const Aged& one) { return one.name == name; });
  return found == kAged.end() ? nullptr : found;
}

// A metric with its own argument, for warm() and worn().
MetricRequest parse_aged_metric(const Aged& aged, std::string_view piece, std::size_t at) {
  const std::size_t open = piece.find('(');
  const auto metric = find_metric(trimmed(piece.substr(0, open)));
  if (!metric || aged.refuses(info(*metric)))
    throw ValueError(std::string(aged.name) + ": " + quoted(piece) +
                         (aged.name == "warm" ? " is no metric of the motor at a temperature"
                                              : " is no metric of a worn motor"),
                     aged.usage, at);
  try {
    return parse_request(info(*metric), piece, open);
  } catch (const ValueError& error) {
    throw ValueError(error.found(), error.expected(), at + error.position());
  }
}

// "warm(speed_at(0.5 N.m))", "warm(stall_torque, 0.5 N.m)", "warm(stall_torque, 0.5 N.m, 100 rpm)"; "warm(stall_torque)" is at the
// mean temperatures of the operation, "worn(X)" always at the end of its life.
MetricRequest parse_aged(const Aged& aged, std::string_view text, std::size_t open) {
  if (open == std::string_view::npos)
    throw ValueError(quoted(text) + " needs a metric in parentheses", aged.usage, text.size());
  const auto pieces = split_list(text.substr(open + 1, text.size() - open - 2));
  const auto at = [&](std::size_t i) {
    return static_cast<std::size_t>(pieces[i].data() - text.data());
  };
  if (pieces.size() > 3)
    throw ValueError(std::string(aged.name) + " takes a metric, a torque and a speed at most",
                     aged.usage, at(3));
  MetricRequest request = parse_aged_metric(aged, pieces[0], at(0));
  LoadPoint own{Argument::none, 0, 0};
  if (aged.load == &MetricRequest::warm_at)
    own = LoadPoint{request.argument, request.at, request.torque};
  if (pieces.size() > 1) {
    MetricInfo load;
    load.name = aged.name, load.argument = Argument::speed_or_torque;
    const MetricRequest point = pieces.size() == 2 ? parse_argument(load, pieces[1], at(1))
                                                   : parse_held(load, pieces[1], pieces[2], text);
    own = LoadPoint{point.argument, point.at, point.torque};
  }
  request.*aged.load = own;
  return request;
}

Term parse_term(std::string_view text, bool whole_text) {
  const std::size_t open = text.find('(');
  const std::string_view name = trimmed(text.substr(0, open));
  if (const Aged* aged = find_aged(name)) return parse_aged(*aged, text, open);
  if (const auto metric = find_metric(name)) return parse_request(info(*metric), text, open);
  const auto parameter = find_parameter(name);
  OwnTerm own = parameter ? nullptr : find_known(name);
  if (!parameter && own == nullptr) unknown_name(name, 0);
  if (parameter && !whole_text) refuse_symbol(info(*parameter), name);
  if (open != std::string_view::npos) {
    throw ValueError(
        quoted(name) + (parameter ? " is a parameter and" : "") + " takes nothing in parentheses",
        "write it without parentheses", open);
  }
  if (own != nullptr) return own;
  return *parameter;
}

// True if the text begins with the name of a metric or parameter: not if it stands in parentheses.
bool find_term(std::string_view text) {
  const std::string_view name = trimmed(text.substr(0, text.find('(')));
  return find_aged(name) != nullptr || find_metric(name).has_value() ||
         find_parameter(name).has_value() || find_known(name) != nullptr;
}

// Place of a term in a list, to which it is added if it is new.
std::size_t place_in(std::vector<Term>& list, const Term& term) {
  const auto found = std::find(list.begin(), list.end(), term);
  const auto place = static_cast<std::size_t>(found - list.begin());
  if (found == list.end()) list.push_back(term);
  return place;
}

std::string_view unit_of(const Term& term) {
  if (const auto* request = std::get_if<MetricRequest>(&term)) return info(request->metric).unit;
  if (const auto* parameter = std::get_if<Parameter>(&term)) return info(*parameter).unit;
  return std::get<OwnTerm>(term)->unit;
}

// Cached, because the units library serves one thread at a time.
Dimension dimension_of(const Term& term) {
  static const std::vector<Dimension> metrics = [] {
    std::vector<Dimension> list;
    for (const MetricInfo& row : metric_table()) list.emplace_back(row.unit);
    return list;
  }();
  static const std::vector<Dimension> parameters = [] {
    std::vector<Dimension> list;
    for (const ParameterInfo& row : parameter_table()) list.emplace_back(row.unit);
    return list;
  }();
  if (const auto* request = std::get_if<MetricRequest>(&term))
    return metrics[static_cast<std::size_t>(request->metric)];
  if (const auto* parameter = std::get_if<Parameter>(&term))
    return parameters[index_of(*parameter)];
  return dimension_of_own(*std::get<OwnTerm>(term));
}

std::string long_text(const Term& term, std::string_view reference) {
  const auto* parameter = std::get_if<Parameter>(&term);
  return std::string(parameter != nullptr ? info(*parameter).name : reference);
}

}  // namespace

std::string MetricExpression::unit() const {
  return formula.is_name() ? std::string(unit_of(terms[0])) : formula.dimension().unit();
}

const MetricRequest* MetricExpression::request() const {
  return formula.is_name() ? std::get_if<MetricRequest>(terms.data()) : nullptr;
}

const Parameter* MetricExpression::parameter() const {
  return formula.is_name() ? std::get_if<Parameter>(terms.data()) : nullptr;
}

bool MetricExpression::has_derivatives() const {
  return std::all_of(terms.begin(), terms.end(), [](const Term& term) {
    const auto* own = std::get_if<OwnTerm>(&term);
    return own == nullptr || (*own)->gradient != nullptr;
  });
}

bool is_absolute(const MetricExpression& expression) {
  const MetricRequest* request = expression.request();
  const Parameter* parameter = expression.parameter();
  return (request != nullptr && info(request->metric).absolute) ||
         (parameter != nullptr && info(*parameter).absolute);
}

MetricExpression expression_of(Parameter parameter) { return parse_metric(info(parameter).name); }

MetricExpression parse_side(std::string_view text) {
  MetricExpression expression;
  const FormulaNames names{
      [&](std::string_view reference, bool whole_text) -> FormulaName {
        const Term term = parse_term(reference, whole_text);
        return {long_text(term, reference), dimension_of(term), place_in(expression.terms, term)};
      },
      "expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'"};
  expression.formula = read_formula(text, names);
  const bool bare = expression.formula.is_name() && find_term(trimmed(text));
  expression.text = bare ? std::string(trimmed(text)) : expression.formula.text();
  return expression;
}

MetricExpression parse_metric(std::string_view text) {
  MetricExpression expression = parse_side(text);
  if (expression.terms.empty())
    throw ValueError(quoted(trimmed(text)) + " has no metric or parameter in it",
                     "expected a metric such as 'stall_torque' or 'torque_at(100 rpm)'");
  return expression;
}

std::vector<MetricExpression> parse_metric_list(std::string_view text) {
  std::vector<MetricExpression> list;
  for (const std::string_view piece : split_list(text)) {
    const auto offset = static_cast<std::size_t>(piece.data() - text.data());
    try {
      list.push_back(parse_metric(piece));
    } catch (const ValueError& error) {
      throw ValueError(error.found(), error.expected(), offset + error.position());
    }
    for (std::size_t i = 0; i + 1 < list.size(); ++i) {
      if (list[i].text == list.back().text) {
        throw ValueError(quoted(piece) + " is given twice", "leave one of them out", offset);
      }
    }
  }
  return list;
}

namespace {

// Says at which torque or frequency the given voltage stops to hold the wave.
bool needs_voltage(Metric metric) {
  return metric == Metric::pull_out_torque || metric == Metric::start_frequency ||
         metric == Metric::pull_out_frequency;
}

// Metrics without argument that need a thermal block; without any drift a motor starts at every temperature or at none.
bool has_temperature(const MotorDesign& design, Metric metric) {
  if (!design.thermal) return false;
  if (metric != Metric::start_temperature) return true;
  return design.stator.voltage && !(design.thermal->drift == ThermalDrift{});
}

}  // namespace

std::vector<MetricExpression> plain_metrics(const MotorDesign& design) {
  std::vector<MetricExpression> list;
  for (const MetricInfo& row : metric_table()) {
    const bool meant = (!row.needs_modes || has_modal_data(design)) &&
                       (!row.needs_geometry || design.stator.geometry) &&
                       (!row.needs_thermal || has_temperature(design, row.metric)) &&
                       (!row.needs_operation || !design.operation.empty()) &&
                       (!row.needs_wear || design.wear) && !row.needs_motion &&
                       (row.metric != Metric::radial_motion_ratio || has_radial_shape(design)) &&
                       (!needs_voltage(row.metric) || design.stator.voltage);
    if (row.argument == Argument::none && meant) list.push_back(parse_metric(row.name));
  }
  return list;
}

}  // namespace twum::inline v0_1::motors
