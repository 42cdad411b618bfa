// SPDX-License-Identifier: Apache-2.0
#include "results/answers.hpp"
#include "telling/renderers.hpp"

#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/io/words.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

// More than these are in summary.json.
constexpr std::size_t kReasonsShown = 5;

std::string end_text(const StoredColumn& variable, double value) {
  const std::string* word = variable.word(value);
  return word == nullptr ? engineering(value, variable.unit) : printable(*word);
}

// "amplitude 0.8 um to 1 um, preload 250 N to 300 N"
std::string where_text(const FailureRegion& region) {
  std::string text;
  for (const FailureRegion::Range& range : region.where) {
    if (!std::isfinite(range.low)) continue;
    text += (text.empty() ? "" : ", ") + range.variable.name + " " +
            end_text(range.variable, range.low);
    if (range.high > range.low) text += " to " + end_text(range.variable, range.high);
  }
  return text;
}

std::string failures_text(const StudyResult& result, const telling::Headline& told) {
  if (result.failures.empty()) return {};
  std::uint64_t count = 0;
  for (const auto& [reason, times] : result.failures) count += times;
  std::string text = std::to_string(count) + " " + told.unanswered + ":\n";
  std::size_t shown = 0;
  for (const FailureRegion& region : result.failure_regions) {
    if (shown++ == kReasonsShown) break;
    text += "  " + std::to_string(region.count) + "  " + printable(region.reason, 200) + "\n";
    const std::string where = where_text(region);
    if (!where.empty()) text += "     at " + where + "\n";
  }
  if (result.failure_regions.size() > kReasonsShown) {
    text += "  and " + counted(result.failure_regions.size() - kReasonsShown, "more reason") +
            ", see summary.json\n";
  }
  return text;
}

std::string count_text(const StudyResult& result) {
  return counted(result.evaluations, "evaluation") + " in " + rounded_text(result.seconds, 3) +
         " s\n";
}

std::string heading(const StudyResult& result, const telling::Headline& told) {
  std::string text = result.study + " (" + std::string(to_string(result.kind)) + ")";
  if (!result.motor.empty()) text += " of " + printable(result.motor);
  return text + ": " + told.badge + "\n";
}

}  // namespace

std::string summary_text(const StudyResult& result, std::span<const std::string> said) {
  const KnownMetrics known(result.own_metrics);
  const telling::Headline told = telling::headline(result);
  std::string text = heading(result, told) + "\n" + telling::terminal_text(told);
  const std::string said_of = telling::terminal_text(telling::sections(result));
  if (!said_of.empty()) text += "\n" + said_of;
  std::string notes;
  for (const std::string& note : result.model_notes)
    if (std::find(said.begin(), said.end(), note) == said.end()) notes += "note: " + note + "\n";
  if (!notes.empty()) text += "\n" + notes;
  return text + "\n" + count_text(result) + failures_text(result, told);
}

std::string summary_markdown(const StudyResult& result) {
  return telling::summary_markdown(result, {});
}

namespace telling {

std::string summary_markdown(const StudyResult& result, const Sources& sources) {
  const KnownMetrics known(result.own_metrics);
  const Headline told = headline(result);
  const auto line = [](const std::string& words) { return markdown(Phrase{words}); };
  std::string text = "# " + line(result.study) + "\n\n" + line(told.title) + "\n\n" +
                     markdown(told) + markdown(sections(result, sources));
  if (!result.model_notes.empty()) text += "\n## Validity\n\n";
  for (const std::string& note : result.model_notes) text += "- " + line(note) + "\n";
  return text;
}

}  // namespace telling
}  // namespace twum::inline v0_1::studies
