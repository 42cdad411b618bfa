// SPDX-License-Identifier: Apache-2.0
#include "plot/study/pictures.hpp"

#include "plot/study/kinds.hpp"
#include "plot/study/told_pictures.hpp"

#include <twum/io/engineering.hpp>
#include <twum/motors/plain_name.hpp>

#include <iterator>
#include <variant>

namespace twum::cli {
namespace {

std::string member_name(const std::optional<studies::StoredColumn>& family, double value) {
  return family ? studies::plain_name(family->name) + " " +
                      studies::printed_engineering(value, family->unit)
                : "motor";
}

std::vector<studies::NamedValue> member_values(const std::optional<studies::StoredColumn>& family,
                                               double value) {
  if (!family) return {};
  return {{family->name, family->unit, value}};
}

}  // namespace

std::vector<Picture> pictures_of(const FinishedStudy& study, const studies::CurveResult& answer) {
  std::vector<Picture> pictures;
  std::vector<NamedMotor> motors;
  for (const studies::CurveResult::Member& member : answer.members)
    add_motor(motors, member_name(answer.family, member.value), study.result.design,
              member_values(answer.family, member.value));
  add_curve_pictures(pictures, study.title("torque-speed curves"), motors);
  return pictures;
}

std::vector<Picture> pictures_of(const FinishedStudy& study,
                                 const studies::CalibrateResult& answer) {
  std::vector<Picture> pictures;
  if (answer.estimates.empty()) return pictures;
  std::vector<NamedMotor> motors;
  for (const std::string& file : answer.files())
    add_motor(motors, file.empty() ? "fitted motor" : file, study.result.design,
              answer.motor_values(file));
  add_curve_pictures(pictures, study.title("the fitted motor"), motors);
  return pictures;
}

std::vector<Picture> study_pictures(const FinishedStudy& study) {
  std::vector<Picture> pictures = std::visit(
      [&](const auto& answer) { return pictures_of(study, answer); }, study.result.answer);
  std::ranges::move(told_pictures(study), std::back_inserter(pictures));
  return pictures;
}

}  // namespace twum::cli
