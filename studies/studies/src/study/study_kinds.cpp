// SPDX-License-Identifier: Apache-2.0
#include "study/study_kinds.hpp"

#include "study/entry_shapes.hpp"

#include <twum/studies/study/study_file.hpp>

#include <array>

namespace twum::studies {
namespace {

template <typename S>
Shape<Study> any(const Shape<S>& shape) {
  return as<Study, S>(
      shape, [](S study) { return Study{std::move(study)}; },
      [](const Study& study) { return std::get<S>(study); });
}

// One row for each alternative of Study, in their order.
template <typename>
struct Rows;
template <typename... S>
struct Rows<std::variant<S...>> {
  static constexpr std::array<std::string_view, sizeof...(S)> kNames{S::kName...};
  static std::array<Shape<Study>, sizeof...(S)> shapes() { return {any(S::shape())...}; }
};
using Kinds = Rows<Study>;

Schema study_variant() {
  Schema study;
  study.kind = ValueKind::variant;
  study.text = "what is asked";
  study.selector = "kind";
  for (std::size_t i = 0; i < Kinds::kNames.size(); ++i) {
    study.words.emplace_back(Kinds::kNames[i]);
    study.alternatives.push_back(study_schema(static_cast<StudyKind>(i)));
  }
  return study;
}

SchemaEntry entry(std::string name, Schema schema, bool required, std::string fallback = {}) {
  SchemaEntry result;
  result.name = std::move(name);
  result.schema = std::move(schema);
  result.required = required;
  result.fallback = std::move(fallback);
  return result;
}

}  // namespace

std::span<const std::string_view> study_kinds() { return Kinds::kNames; }

std::string_view to_string(StudyKind kind) { return Kinds::kNames[static_cast<std::size_t>(kind)]; }

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
  static const auto all = Kinds::shapes();
  return all.at(static_cast<std::size_t>(kind));
}

Schema study_schema(StudyKind kind) { return study_shape(kind).schema; }

const Schema& study_file_schema() {
  static const Schema schema = [] {
    Schema motor;
    motor.kind = ValueKind::any_of;
    motor.text = "the motor: a path beside this file, or its entries";
    motor.alternatives = {path("a motor file", "ring-60.yaml").schema, motor_schema()};
    Schema file;
    file.kind = ValueKind::mapping;
    file.text = "a study for twum";
    file.entries = {motor_file_schema().entries.front(), entry("motor", motor, true),
                    entry("set", shapes::overrides().schema, false, "the motor as it is"),
                    entry("study", study_variant(), true)};
    return file;
  }();
  return schema;
}

}  // namespace twum::studies
