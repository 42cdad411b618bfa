// SPDX-License-Identifier: Apache-2.0
#include "entries/study_kinds.hpp"

#include <twum/studies/study_file.hpp>

#include <array>

namespace twum::inline v0_1::studies {
namespace {

// Made when first asked for: the shapes of all kinds take longer to make than many a study runs.
template <typename S>
const Shape<Study>& shape_of() {
  static const Shape<Study> shape = shape_as<Study, S>(
      S::shape(), [](S study) { return Study{std::move(study)}; },
      [](const Study& study) { return std::get<S>(study); });
  return shape;
}

// One row for each alternative of Study, in their order.
template <typename>
struct Rows;
template <typename... S>
struct Rows<std::variant<S...>> {
  static constexpr std::array<std::string_view, sizeof...(S)> kNames{S::kName...};
  static constexpr std::array<std::string_view, sizeof...(S)> kTitles{S::kTitle...};
  static constexpr std::array<const Shape<Study>& (*)(), sizeof...(S)> kShapes{shape_of<S>...};
};
using Kinds = Rows<Study>;

Shape<Study> any_study() {
  std::vector<Shape<Study>> kinds;
  std::vector<std::string> names;
  for (std::size_t i = 0; i < Kinds::kNames.size(); ++i) {
    kinds.push_back(study_shape(static_cast<StudyKind>(i)));
    names.emplace_back(Kinds::kNames[i]);
  }
  return one_of<Study>(
      "what is asked", std::move(kinds), [](const Study& study) { return study.index(); }, "kind",
      std::move(names));
}

using MotorEntry = std::variant<std::string, MotorFile>;

template <typename T>
Shape<MotorEntry> motor_as(const Shape<T>& shape) {
  return shape_as<MotorEntry, T>(
      shape, [](T given) { return MotorEntry{std::move(given)}; },
      [](const MotorEntry& entry) { return std::get<T>(entry); });
}

Shape<StudyText> file_with(const Shape<Study>& study) {
  return mapping<StudyText>(
      "a study for twum",
      {version_field<StudyText>(),
       required<StudyText>(
           "motor",
           one_of<MotorEntry>(
               "the motor: a path relative to the folder of this file, or its entries",
               {motor_as(path("a motor file", "ring-60.yaml")), motor_as(motor_shape())},
               [](const MotorEntry& entry) { return entry.index(); }),
           &StudyText::motor),
       optional<StudyText>("set", shapes::overrides(), &StudyText::set, "the motor as it is"),
       required<StudyText>("study", study, &StudyText::study)});
}

}  // namespace

std::span<const std::string_view> study_kinds() { return Kinds::kNames; }

std::string_view to_string(StudyKind kind) { return Kinds::kNames[static_cast<std::size_t>(kind)]; }

std::string_view title_of(StudyKind kind) { return Kinds::kTitles[static_cast<std::size_t>(kind)]; }

std::optional<StudyKind> find_study_kind(std::string_view name) {
  for (std::size_t i = 0; i < Kinds::kNames.size(); ++i) {
    if (Kinds::kNames[i] == name) return static_cast<StudyKind>(i);
  }
  return {};
}

std::uint64_t standard_samples(SensitivityMethod method) {
  return method == SensitivityMethod::morris ? 32 : 1024;
}

const Shape<Study>& study_shape(StudyKind kind) {
  return Kinds::kShapes.at(static_cast<std::size_t>(kind))();
}

Schema study_schema(StudyKind kind) { return study_shape(kind).schema; }

const Shape<StudyText>& study_file_shape() {
  static const Shape<StudyText> shape = file_with(any_study());
  return shape;
}

Shape<StudyText> study_file_shape(StudyKind kind) {
  return file_with(one_of<Study>("what is asked", {study_shape(kind)},
                                 [](const Study&) { return std::size_t{0}; }, "kind",
                                 {std::string(to_string(kind))}));
}

const Schema& study_file_schema() { return study_file_shape().schema; }

}  // namespace twum::inline v0_1::studies
