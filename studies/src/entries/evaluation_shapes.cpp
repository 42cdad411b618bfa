// SPDX-License-Identifier: Apache-2.0
// Studies that evaluate designs without a search: curves, frequency curves, sweeps, sensitivities.
#include "entries/entry_shapes.hpp"
#include "entries/spacing.hpp"
#include "entries/tolerance_shape.hpp"

#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::inline v0_1::studies {

using namespace shapes;

namespace {

constexpr double kMostDesigns = 1e9;  // of one sweep

// Lines for templates.
constexpr const char* kSweep =
    "amplitude: {min: 0.8 um, max: 2.2 um, points: 8}\n"
    "preload: [100 N, 160 N, 220 N]";

using Variable = SweepStudy::Variable;

Shape<Variable> sweep_variable(const ParameterInfo& row) {
  Field<Variable> points =
      standard<Variable>("points", count("grid points", "5", 2, 1e6), &Variable::points);
  points.entry.fallback = std::to_string(Variable{}.points) + "; for a grid";
  const auto limits = mapping<Variable>(
      std::string(row.text),
      {required<Variable>("min", value_of(row, kSmallestValue), &Variable::min),
       required<Variable>("max", value_of(row, kLargestValue), &Variable::max), std::move(points),
       standard<Variable>("scale", spacing(), &Variable::scale)},
      [](Variable& range, const Given& given, Diagnostics& diagnostics) {
        if (given.right("min") != nullptr && given.right("max") != nullptr)
          rising(given, "min", range.min, "max", range.max, diagnostics);
        check_log(given, range.min, diagnostics);
        return true;
      });
  const auto listed = shape_as<Variable, std::vector<double>>(
      list("values", value_of(row, "a value")),
      [](std::vector<double> values) { return Variable{.values = std::move(values)}; },
      [](const Variable& variable) { return variable.values; });
  auto shape =
      one_of<Variable>(std::string(row.text), {listed, limits},
                       [](const Variable& variable) { return variable.values.empty() ? 1U : 0U; });
  for (SchemaEntry& entry : shape.schema.alternatives.own().back().entries.own())
    for (StandardValue& one : entry.standards)
      if (entry.name == "points") one = {one.value, "sampling", {"grid"}};
  return shape;
}

// Adds errors for entries of a sweep that do not fit its sampling.
class SweepChecker {
 public:
  SweepChecker(const SweepStudy& study, const Given& given, Diagnostics& diagnostics)
      : study_(study), given_(given), diagnostics_(diagnostics) {
    const YamlNode* sampling = given.find("sampling");
    word_ = sampling != nullptr ? sampling->scalar : "";
  }

  void check() {
    const YamlNode* variables = given_.find("variables");
    if (variables == nullptr || variables->kind != YamlNode::Kind::mapping) return;
    const bool drawn = word_ == "lhs" || word_ == "sobol";
    if (!drawn) refuse_entry("samples");
    if (!drawn) refuse_entry("seed");
    for (const YamlEntry& entry : variables->entries) {
      if (drawn) refuse_points(entry);
      if (word_ == "list") require_list(entry);
    }
    if (word_ == "grid")
      for (const Variable& variable : study_.variables) check_whole_points(variable, *variables);
    if (word_ == "list") check_lengths(*variables);
    if (word_ == "grid") check_size(*variables);
  }

 private:
  std::string path_of(const std::string& key) const { return given_.path("variables") + "." + key; }

  void refuse_entry(const char* name) {
    const YamlNode* node = given_.find(name);
    if (node == nullptr) return;
    diagnostics_.add(node->mark, given_.path(name), "given for sampling '" + word_ + "'",
                     "used by lhs and sobol only; leave it out");
  }

  void refuse_points(const YamlEntry& entry) {
    const YamlNode* points = entry.value.find("points");
    if (points == nullptr) return;
    diagnostics_.add(points->mark, path_of(entry.key) + ".points",
                     "given for sampling '" + word_ + "'",
                     "used by grid only; 'samples' below 'study' is the number of designs");
  }

  void require_list(const YamlEntry& entry) {
    if (entry.value.kind != YamlNode::Kind::mapping) return;
    diagnostics_.add(entry.value.mark, path_of(entry.key), "found a range, but sampling is 'list'",
                     "expected a list of values, or sampling 'grid'");
  }

  void check_lengths(const YamlNode& variables) {
    const YamlEntry* first = nullptr;
    for (const YamlEntry& entry : variables.entries) {
      if (entry.value.kind != YamlNode::Kind::list) continue;
      if (first == nullptr) first = &entry;
      if (entry.value.items.size() == first->value.items.size()) continue;
      diagnostics_.add({entry.value.mark, path_of(entry.key),
                        counted(entry.value.items.size(), "value") + ", but " + first->key +
                            " has " + std::to_string(first->value.items.size()),
                        "sampling 'list' needs lists of equal length; for all combinations use "
                        "sampling 'grid'",
                        first->value.mark, first->key + " given here"});
    }
  }

  // A grid over an integer parameter, such as wavelengths, must consist of integers.
  void check_whole_points(const Variable& range, const YamlNode& variables) {
    if (!info(range.parameter).integer || !range.values.empty() || !(range.min < range.max)) return;
    if (range.scale == optim::Scale::log && !(range.min > 0)) return;
    const auto last = static_cast<double>(range.points - 1);
    for (std::uint64_t i = 0; i < range.points; ++i) {
      const double value =
          between(range.min, range.max, static_cast<double>(i) / last, range.scale);
      if (std::abs(value - std::round(value)) <= 1e-9 * value) continue;
      const YamlEntry& entry = entry_of(range.parameter, variables);
      diagnostics_.add(entry.value.mark, path_of(entry.key),
                       "a grid point at " + rounded_text(value, 6),
                       "must be whole numbers; give a list of values, or other 'points'");
      return;
    }
  }

  static const YamlEntry& entry_of(Parameter parameter, const YamlNode& variables) {
    return *std::find_if(variables.entries.begin(), variables.entries.end(),
                         [&](const YamlEntry& e) { return find_parameter(e.key) == parameter; });
  }

  void check_size(const YamlNode& variables) {
    double designs = 1;
    for (const Variable& one : study_.variables)
      designs *= static_cast<double>(one.values.empty() ? one.points : one.values.size());
    if (designs <= kMostDesigns) return;
    diagnostics_.add(variables.mark, given_.path("variables"),
                     "a grid of " + rounded_text(designs, 3) + " designs",
                     "at most " + rounded_text(kMostDesigns, 1) +
                         "; take fewer points, or "
                         "sampling 'lhs' or 'sobol'");
  }

  const SweepStudy& study_;
  const Given& given_;
  Diagnostics& diagnostics_;
  std::string word_;
};

void refuse(const Given& given, const char* name, const std::string& found, const char* remedy,
            Diagnostics& diagnostics) {
  if (const YamlNode* node = given.find(name))
    diagnostics.add(node->mark, given.path(name), found, remedy);
}

void refuse_starts(const Given& given, const std::string& method, Diagnostics& diagnostics) {
  const YamlNode* variables = given.find("variables");
  if (variables == nullptr) return;
  for (const YamlEntry& entry : variables->entries) {
    const YamlNode* start = entry.value.find("start");
    if (start == nullptr) continue;
    diagnostics.add(start->mark, given.path("variables") + "." + entry.key + ".start",
                    "given for method '" + method + "'",
                    "used by method 'local' only; the other methods use the whole range");
  }
}

bool check_sensitivity(SensitivityStudy& study, const Given& given, Diagnostics& diagnostics) {
  check_repeats(given, diagnostics);
  const YamlNode* node = given.find("method");
  if (node == nullptr) return true;
  const std::string& method = node->scalar;
  const std::string found = "given for method '" + method + "'";
  if (method == "local")
    refuse(given, "samples", found, "derivatives need no samples; leave it out", diagnostics);
  if (method == "local" || method == "morris") {
    refuse(given, "width", found, "used by method 'sobol' only; leave it out", diagnostics);
    refuse(given, "max_samples", found, "used by method 'sobol' only; leave it out", diagnostics);
  }
  if (method == "sobol" && given.find("width") == nullptr)
    refuse(given, "max_samples", "given without a width", "used with 'width' only; leave it out",
           diagnostics);
  if (method == "morris")
    refuse(given, "tolerances", found,
           "screening moves across ranges: give 'variables' with them, or use method 'sobol' or "
           "'local'",
           diagnostics);
  if (method == "morris" || method == "sobol") refuse_starts(given, method, diagnostics);
  const bool fewer = given.right("samples") != nullptr && given.right("max_samples") != nullptr &&
                     *study.max_samples < *study.samples;
  if (method == "sobol" && given.find("width") != nullptr && fewer)
    refuse(given, "max_samples", "less than samples", "must be at least samples", diagnostics);
  return true;
}

// Samples of morris and of sobol: one entry with a default for each method.
Field<SensitivityStudy> sensitivity_samples() {
  using Method = SensitivityMethod;
  const auto text = [](Method method) { return std::to_string(standard_samples(method)); };
  auto field = optional<SensitivityStudy>(
      "samples",
      count("morris: number of trajectories; sobol: number of base samples, each of (variables + "
            "2) motors, rounded up to a power of two, at least 256",
            "1024", 1, 1e9),
      &SensitivityStudy::samples,
      text(Method::morris) + " for morris, " + text(Method::sobol) + " for sobol");
  field.write = [](const SensitivityStudy& from) -> std::optional<YamlNode> {
    if (from.method == Method::local) return {};
    return scalar_node(std::to_string(from.samples.value_or(standard_samples(from.method))));
  };
  field.entry.standards = {{scalar_node(text(Method::morris)), "method", {"morris"}},
                           {scalar_node(text(Method::sobol)), "method", {"sobol"}}};
  return field;
}

// One of two lists of a sensitivity study, of which one is needed.
Field<SensitivityStudy> either(Field<SensitivityStudy> field, const char* other, bool usual) {
  field.entry.required = usual;
  field.entry.alternative_entry = other;
  field.write = [write = field.write, usual](const SensitivityStudy& from) {
    return from.tolerances.empty() == usual ? write(from) : std::nullopt;
  };
  return field;
}

bool is_drawn(const SweepStudy& study) {
  return study.sampling == Sampling::lhs || study.sampling == Sampling::sobol;
}

// The entry `variables` of a sweep. Numbers of points are those of a grid.
Field<SweepStudy> sweep_variables() {
  auto field = required<SweepStudy>(
      "variables", by_parameter<Variable>(sweep_variable, "what is varied", kSweep),
      &SweepStudy::variables);
  field.write = [write = field.write](const SweepStudy& from) {
    std::optional<YamlNode> node = write(from);
    if (from.sampling == Sampling::grid) return node;
    for (YamlEntry& variable : node->entries)
      std::erase_if(variable.value.entries,
                    [](const YamlEntry& entry) { return entry.key == "points"; });
    return node;
  };
  return field;
}

// An entry of lhs and sobol only.
Field<SweepStudy> of_drawn(Field<SweepStudy> field) {
  const YamlNode value = *field.write(SweepStudy{});
  field.has_standard = false;
  field.entry.fallback = typed_text(value) + "; for lhs and sobol";
  field.entry.standards = {{value, "sampling", {"lhs", "sobol"}}};
  field.write = [write = field.write](const SweepStudy& from) {
    return is_drawn(from) ? write(from) : std::nullopt;
  };
  return hidden(std::move(field));
}

}  // namespace

const char* to_string(Sampling value) noexcept {
  switch (value) {
    case Sampling::grid: return "grid";
    case Sampling::list: return "list";
    case Sampling::lhs: return "lhs";
    case Sampling::sobol: return "sobol";
  }
  return "unknown";
}

const char* to_string(SweepDirection value) noexcept {
  switch (value) {
    case SweepDirection::up: return "up";
    case SweepDirection::down: return "down";
    case SweepDirection::both: return "both";
  }
  return "unknown";
}

const char* to_string(SensitivityMethod value) noexcept {
  switch (value) {
    case SensitivityMethod::local: return "local";
    case SensitivityMethod::morris: return "morris";
    case SensitivityMethod::sobol: return "sobol";
  }
  return "unknown";
}

static Shape<std::vector<double>> loads() {
  using Loads = std::vector<double>;
  const Shape<double> load = quantity("load of the rotor", "N.m", "0.5 N.m");
  return one_of<Loads>(
      "load torque, or a list of load torques for a family",
      {shape_as<Loads, double>(
           load, [](double value) { return Loads{value}; },
           [](const Loads& values) { return values.front(); }),
       list("loads", load, 2)},
      [](const Loads& values) { return values.size() == 1 ? std::size_t{0} : std::size_t{1}; });
}

Shape<FrequencyStudy> FrequencyStudy::shape() {
  using F = FrequencyStudy;
  return mapping<F>(
      "sweeps of the frequency of a motor under a voltage, or of a family over one parameter or "
      "its load",
      {kind_field<F>(),
       optional<F>("family", shapes::family("voltage: [80 V, 100 V, 120 V]"), &F::family,
                   "the motor alone"),
       optional<F>("from", quantity("lowest frequency", "Hz", "39 kHz"), &F::from,
                   "below all resonances and jumps"),
       optional<F>("to", quantity("highest frequency", "Hz", "45 kHz"), &F::to, "above all jumps"),
       standard<F>("points", count("frequencies of each sweep", "201", 2, 1e6), &F::points),
       hidden(optional<F>("torque", loads(), &F::torque, "0 N.m")),
       hidden(optional<F>("speed", quantity("rotor speed, instead of a torque", "rad/s", "0 rpm"),
                          &F::speed, "the speed under the torque")),
       standard<F>(
           "direction",
           word<SweepDirection>("direction of the sweeps",
                                {SweepDirection::up, SweepDirection::down, SweepDirection::both}),
           &F::direction)},
      [](F& study, const Given& given, Diagnostics& diagnostics) {
        if (study.from && study.to)
          rising(given, "from", *study.from, "to", *study.to, diagnostics);
        if (study.family && study.torque && study.torque->size() > 1) {
          diagnostics.add(given.find("torque")->mark, given.path("torque"),
                          "several loads cannot be given together with 'family'",
                          "give one load, or leave out 'family'");
          return false;
        }
        const YamlNode* speed = given.find("speed");
        if (speed == nullptr || given.find("torque") == nullptr) return true;
        diagnostics.add(speed->mark, given.path("speed"), "cannot be given together with 'torque'",
                        "give the torque, or the speed");
        return false;
      });
}

Shape<CurveStudy> CurveStudy::shape() {
  return mapping<CurveStudy>(
      "one motor, or a family over one parameter",
      {kind_field<CurveStudy>(),
       optional<CurveStudy>("family", shapes::family("amplitude: [1.0 um, 1.5 um, 2.0 um]"),
                            &CurveStudy::family, "the motor alone"),
       standard<CurveStudy>("points", count("points of each curve", "51", 2, 1e6),
                            &CurveStudy::points)});
}

Shape<SweepStudy> SweepStudy::shape() {
  using S = SweepStudy;
  return mapping<S>(
      "a grid, list or sample of designs",
      {kind_field<S>(), sweep_variables(), derived_field<S>(),
       required<S>("sampling",
                   word<Sampling>("how designs are chosen",
                                  {Sampling::grid, Sampling::list, Sampling::lhs, Sampling::sobol}),
                   &S::sampling),
       required<S>("metrics", shapes::metrics(), &S::metrics),
       of_drawn(standard<S>("samples", shapes::samples(), &S::samples)),
       of_drawn(standard<S>("seed", shapes::seed(), &S::seed))},
      [](S& study, const Given& given, Diagnostics& diagnostics) {
        check_repeats(given, diagnostics);
        SweepChecker(study, given, diagnostics).check();
        return true;
      });
}

Shape<SensitivityStudy> SensitivityStudy::shape() {
  using S = SensitivityStudy;
  auto method = word<SensitivityMethod>(
      "local derivatives, screening, or variance shares",
      {SensitivityMethod::local, SensitivityMethod::morris, SensitivityMethod::sobol});
  method.schema.example = "sobol";
  return mapping<S>(
      "which parameter matters",
      {kind_field<S>(), required<S>("method", method, &S::method),
       either(required<S>("variables", shapes::variables("what is varied", kRanges), &S::variables),
              "tolerances", true),
       either(required<S>("tolerances", shapes::tolerances("how motors scatter"), &S::tolerances),
              "variables", false),
       derived_field<S>(), required<S>("metrics", shapes::metrics(), &S::metrics),
       sensitivity_samples(),
       standard<S>("confidence", fraction("level of the confidence intervals", "0.95"),
                   &S::confidence),
       hidden(optional<S>(
           "width",
           fraction(
               "sobol: the samples are doubled until no confidence interval is wider than this",
               "0.05"),
           &S::width, "none: one round")),
       hidden(optional<S>("max_samples", count("largest number of base samples", "65536", 1, 1e12),
                          &S::max_samples, "64 times samples")),
       standard<S>("seed", shapes::seed(), &S::seed)},
      check_sensitivity);
}

}  // namespace twum::inline v0_1::studies
