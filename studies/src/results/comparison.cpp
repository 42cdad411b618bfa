// SPDX-License-Identifier: Apache-2.0
#include <twum/studies/comparison.hpp>

#include "results/stored_summary.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/result_store.hpp>
#include <twum/io/value_error.hpp>
#include <twum/motors/expression.hpp>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>

namespace twum::inline v0_1::studies {
namespace {

namespace fs = std::filesystem;
using Json = nlohmann::ordered_json;

Json read_summary(const std::string& directory) {
  std::error_code ignored;
  if (!fs::is_directory(directory, ignored))
    throw InputError(directory + ": no such directory; give one that 'twum run' wrote");
  const std::string path = (fs::path(directory) / "summary.json").string();
  if (!fs::exists(path, ignored))
    throw InputError(directory + ": holds no result: there is no summary.json");
  return stored_summary(path);
}

// SI unit of a parameter or metric; "1" for other names.
std::string unit_of(const std::string& name) {
  try {
    return std::string(parse_metric(name).unit());
  } catch (const ValueError&) {
    return "1";
  }
}

// The entry with a name; an empty object if there is none.
const Json& below(const Json& json, const std::string& name) {
  static const Json nothing = Json::object();
  return json.is_object() && json.contains(name) ? json[name] : nothing;
}

// A number that may have an interval round it.
const Json& estimate_of(const Json& json) {
  return json.is_object() && json.contains("value") ? json["value"] : json;
}

class Comparer {
 public:
  explicit Comparer(std::size_t results) : results_(results) {}

  void add(std::size_t result, const Json& summary) {
    result_ = result;
    for (const char* name : {"study", "kind", "motor", "outcome", "version"}) word(summary, name);
    for (const char* name : {"evaluations", "seed"}) word(summary, name);
    std::uint64_t failures = 0;
    for (const auto& [reason, count] : below(summary, "failures").items())
      failures += count.is_number_unsigned() ? count.get<std::uint64_t>() : 0;
    text("study", "failures", std::to_string(failures));
    best(summary);
    front(summary);
    tables(summary);
  }

  std::vector<ComparisonRow> take() { return std::move(rows_); }

 private:
  ComparisonRow& row(const std::string& group, const std::string& name, const std::string& unit) {
    const auto there = std::find_if(rows_.begin(), rows_.end(), [&](const ComparisonRow& one) {
      return one.group == group && one.name == name;
    });
    if (there != rows_.end()) return *there;
    // Beside those of its group.
    auto place = std::find_if(rows_.rbegin(), rows_.rend(), [&](const ComparisonRow& one) {
                   return one.group == group;
                 }).base();
    if (place == rows_.begin()) place = rows_.end();
    return *rows_.insert(place, {group, name, unit, {}, {}});
  }

  void number(const std::string& group, const std::string& name, const std::string& unit,
              const Json& value) {
    ComparisonRow& one = row(group, name, unit);
    one.values.resize(results_, kNoValue);
    if (value.is_number()) one.values[result_] = value.get<double>();
  }

  void text(const std::string& group, const std::string& name, const std::string& value) {
    ComparisonRow& one = row(group, name, "");
    one.words.resize(results_);
    one.words[result_] = value;
  }

  void word(const Json& summary, const char* name) {
    const Json& value = below(summary, name);
    if (value.is_object()) return;  // not there
    text("study", name, value.is_string() ? value.get<std::string>() : value.dump());
  }

  void named(const std::string& group, const Json& values) {
    for (const auto& [name, value] : values.items()) number(group, name, unit_of(name), value);
  }

  void best(const Json& summary) {
    const Json& one = below(summary, "best");
    if (!one.is_object() || one.empty()) return;
    for (const auto& [name, set] : below(one, "choice").items())
      text("best design", name, set.is_string() ? set.get<std::string>() : set.dump());
    named("best design", below(one, "design"));
    named("metrics there", below(one, "metrics"));
    const Json& certificate = below(one, "certificate");
    if (certificate.is_object() && !certificate.empty())
      text("study", "certified", certificate.value("passed", false) ? "yes" : "no");
  }

  // Size and hypervolume of a front.
  void front(const Json& summary) {
    const Json& points = below(summary, "front");
    if (!points.is_array()) return;
    text("front", "points", std::to_string(points.size()));
    number("front", "hypervolume", "1", below(summary, "hypervolume"));
    if (points.empty()) return;
    for (const auto& [name, ignored] : below(points.front(), "metrics").items()) {
      double low = kNoValue;
      double high = kNoValue;
      for (const Json& point : points) {
        const Json& value = below(below(point, "metrics"), name);
        if (!value.is_number()) continue;
        low = std::fmin(low, value.get<double>());
        high = std::fmax(high, value.get<double>());
      }
      number("front", "least " + name, unit_of(name), Json(low));
      number("front", "most " + name, unit_of(name), Json(high));
    }
  }

  // Numbers by metric or parameter: spreads, indices, estimates, curves.
  void tables(const Json& summary) {
    const Json& metrics = below(summary, "metrics");
    for (const auto& [name, values] : metrics.items()) {
      for (const char* what : {"min", "median", "max", "mean", "sd"}) {
        if (values.is_object() && values.contains(what)) {
          const Json& value = estimate_of(values[what]);
          number(what, name, unit_of(name), value);
        }
      }
    }
    if (summary.contains("yield")) number("yield", "yield", "1", estimate_of(summary["yield"]));
    for (const auto& [name, estimate] : below(summary, "estimates").items())
      number("estimate", name, unit_of(name), below(estimate, "value"));
    if (summary.contains("residual_rms"))
      number("estimate", "residual_rms", "1", summary["residual_rms"]);
    indices(below(summary, "indices"));
    const Json& curves = below(summary, "curves");
    for (std::size_t i = 0; i < curves.size(); ++i)
      named("curve " + std::to_string(i + 1), below(curves[i], "metrics"));
  }

  void indices(const Json& all) {
    for (const auto& [metric, variables] : all.items()) {
      for (const auto& [variable, values] : variables.items()) {
        for (const char* what : {"first", "total", "mu_star", "elasticity"}) {
          if (!values.is_object() || !values.contains(what)) continue;
          const Json& value = estimate_of(values[what]);
          const bool own_unit = std::string_view(what) == "mu_star";
          number(std::string(what) + " of " + metric, variable, own_unit ? unit_of(metric) : "1",
                 value);
        }
      }
    }
  }

  std::size_t results_;
  std::size_t result_{0};
  std::vector<ComparisonRow> rows_;
};

}  // namespace

Comparison compare_results(std::span<const std::string> directories) {
  Comparison comparison;
  std::vector<Json> summaries;
  for (const std::string& directory : directories) summaries.push_back(read_summary(directory));
  Comparer comparer(directories.size());
  for (std::size_t i = 0; i < directories.size(); ++i) {
    comparison.names.push_back(directories[i]);
    from_summary(directories[i] + "/summary.json", [&] { comparer.add(i, summaries[i]); });
  }
  comparison.rows = comparer.take();
  for (ComparisonRow& row : comparison.rows) {
    if (!row.words.empty()) row.words.resize(directories.size());
    if (!row.values.empty()) row.values.resize(directories.size(), kNoValue);
  }
  return comparison;
}

}  // namespace twum::inline v0_1::studies
