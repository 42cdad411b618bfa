// SPDX-License-Identifier: Apache-2.0
#include "results/calibration_words.hpp"

#include <twum/core/parameters.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace twum::inline v0_1::studies {
namespace {

struct Words {
  Parameter parameter;
  const char* rises;
  const char* falls;
};

constexpr std::array kWords{
    Words{Parameter::contact_radius, "a larger contact radius", "a smaller contact radius"},
    Words{Parameter::contact_width, "a wider contact", "a narrower contact"},
    Words{Parameter::neutral_plane_distance, "a thicker stator", "a thinner stator"},
    Words{Parameter::frequency, "a higher frequency", "a lower frequency"},
    Words{Parameter::frequency_ratio, "a higher frequency", "a lower frequency"},
    Words{Parameter::amplitude, "a larger wave", "a smaller wave"},
    Words{Parameter::voltage, "more voltage", "less voltage"},
    Words{Parameter::resonance_frequency, "a higher resonance", "a lower resonance"},
    Words{Parameter::modal_mass, "a heavier stator", "a lighter stator"},
    Words{Parameter::modal_damping, "a more damped stator", "a less damped stator"},
    Words{Parameter::quality_factor, "a less damped stator", "a more damped stator"},
    Words{Parameter::force_factor, "a stronger drive", "a weaker drive"},
    Words{Parameter::blocked_capacitance, "more capacitance", "less capacitance"},
    Words{Parameter::thickness, "a thicker layer", "a thinner layer"},
    Words{Parameter::youngs_modulus, "a stiffer layer", "a softer layer"},
    Words{Parameter::shear_modulus, "a layer stiffer in shear", "a layer softer in shear"},
    Words{Parameter::density, "a heavier layer", "a lighter layer"},
    Words{Parameter::loss_factor, "more loss in the layer", "less loss in the layer"},
    Words{Parameter::shear_viscosity, "more loss in the layer", "less loss in the layer"},
    Words{Parameter::kinetic_friction, "more friction", "less friction"},
    Words{Parameter::static_friction, "more static friction", "less static friction"},
    Words{Parameter::preload, "more preload", "less preload"},
};

}  // namespace

std::string rising_words(const std::string& parameter, bool rises) {
  const auto found = std::find_if(kWords.begin(), kWords.end(), [&](const Words& words) {
    return info(words.parameter).name == parameter;
  });
  if (found == kWords.end()) return (rises ? "more " : "less ") + parameter;
  return rises ? found->rises : found->falls;
}

std::string combination_words(const CalibrateResult::Combination& combination) {
  std::string text;
  const char* joint = "";
  for (const CalibrateResult::Combination::Part& part : combination.parts) {
    const bool rises = part.percent > 0;
    text += joint + rising_words(part.name, rises) + " (" + part.name + (rises ? " +" : " -") +
            rounded_text(std::fabs(part.percent), 2) + " %)";
    joint = &part == &combination.parts.front() ? " with " : " and ";
  }
  return text;
}

std::string fold_words() {
  return "the estimates are at a fold, or close to one, where a change of several parameters "
         "together does not change the measured numbers to first order. Correlations and changes "
         "with a fixed parameter are linear extrapolations, "
         "which say nothing there";
}

std::string place_words(const CalibrateResult::Point& point) {
  const std::string of = point.torque() ? "" : " of " + point.quantity;
  if (point.argument == Argument::none) return of;
  return of + " at " +
         engineering(point.at, point.argument == Argument::speed ? "rad/s" : "N.m", 4);
}

std::string column_name(const CalibrateResult::ColumnOffset& offset) {
  const std::string what = offset.quantity == "torque_at" ? "torque" : offset.quantity;
  return offset.table.empty() ? what : what + " (" + offset.table + ")";
}

std::string offset_words(const CalibrateResult::ColumnOffset& offset) {
  return "the " + std::to_string(offset.count) + " readings fit best if each is " +
         engineering(std::fabs(offset.offset), offset.unit, 3) + " too " +
         (offset.offset > 0 ? "large" : "small");
}

const char* to_string(CalibrateResult::Bound value) noexcept {
  switch (value) {
    case CalibrateResult::Bound::none: return "none";
    case CalibrateResult::Bound::min: return "min";
    case CalibrateResult::Bound::max: return "max";
  }
  return "unknown";
}

}  // namespace twum::inline v0_1::studies
