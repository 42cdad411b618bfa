// SPDX-License-Identifier: Apache-2.0
#include "study/sampling_checks.hpp"

#include "study/distribution_entries.hpp"
#include "study/repeats.hpp"

#include <twum/studies/schema/validate.hpp>
#include <twum/studies/text/number.hpp>
#include <twum/studies/text/value_error.hpp>
#include <twum/studies/text/words.hpp>

#include <optional>
#include <string>

namespace twum::studies {
namespace {

void refuse(const YamlNode& study, const char* name, const std::string& found, const char* remedy,
            Diagnostics& diagnostics) {
  const YamlNode* node = study.find(name);
  if (node != nullptr) diagnostics.add(node->mark, std::string("study.") + name, found, remedy);
}

std::optional<double> number_of(const YamlNode& study, const char* name) {
  const YamlNode* node = study.find(name);
  return node == nullptr ? std::nullopt : parse_number(trimmed(node->scalar));
}

void check_starts(const YamlNode& study, const std::string& method, Diagnostics& diagnostics) {
  const YamlNode* variables = study.find("variables");
  if (variables == nullptr) return;
  for (const YamlEntry& entry : variables->entries) {
    const YamlNode* start = entry.value.find("start");
    if (start == nullptr) continue;
    diagnostics.add(start->mark, "study.variables." + entry.key + ".start",
                    "given for method '" + method + "'",
                    "only of method 'local'; the others look at the whole range");
  }
}

void check_distribution(const YamlEntry& entry, Diagnostics& diagnostics) {
  const auto parameter = find_parameter(entry.key);
  if (!parameter) return;
  const std::string path = "study.variables." + entry.key;
  try {
    const Distribution read = entries::distribution(entry.value, info(*parameter));
    if (read.cut_off() <= entries::kMostCutOff) return;
    diagnostics.add(entry.value.mark, path,
                    rounded_text(100 * read.cut_off(), 3) +
                        " % of the distribution lies outside the admissible range",
                    "at most 1 % may be cut off: a smaller spread, or a lognormal or triangular "
                    "distribution, has less there");
  } catch (const ValueError& error) {
    // What the table of the file refuses by itself is said there.
    if (const YamlNode* mean = entry.value.find("mean");
        mean != nullptr && error.found().find("lognormal") != std::string::npos)
      diagnostics.add(mean->mark, path + ".mean", error.found(), error.expected());
  }
}

}  // namespace

void check_sensitivity(const YamlNode& study, Diagnostics& diagnostics) {
  const YamlNode* node = study.find("method");
  if (node == nullptr) return;
  const std::string& method = node->scalar;
  const std::string found = "given for method '" + method + "'";
  if (method == "local")
    refuse(study, "samples", found, "derivatives need no samples; leave it out", diagnostics);
  if (method == "local" || method == "morris") {
    refuse(study, "width", found, "only of method 'sobol'; leave it out", diagnostics);
    refuse(study, "max_samples", found, "only of method 'sobol'; leave it out", diagnostics);
  }
  if (method == "sobol" && study.find("width") == nullptr)
    refuse(study, "max_samples", "given without a width", "only where 'width' asks for rounds",
           diagnostics);
  if (method == "morris" || method == "sobol") check_starts(study, method, diagnostics);
  const auto samples = number_of(study, "samples");
  const auto most = number_of(study, "max_samples");
  if (method == "sobol" && study.find("width") != nullptr && samples && most && *most < *samples)
    refuse(study, "max_samples", "less than samples", "must be at least samples", diagnostics);
}

void check_uncertainty(const YamlNode& study, Diagnostics& diagnostics) {
  if (const YamlNode* variables = study.find("variables")) {
    for (const YamlEntry& entry : variables->entries) check_distribution(entry, diagnostics);
  }
  const YamlNode* quantiles = study.find("quantiles");
  if (quantiles == nullptr) return;
  Repeats repeats("study.quantiles", "leave one of them out", diagnostics);
  Schema probability;  // 5 % is 0.05
  probability.kind = ValueKind::quantity;
  for (const YamlNode& item : quantiles->items) {
    if (const auto value = quantity_of(item, probability)) repeats.see(item, number_text(*value));
  }
}

}  // namespace twum::studies
