// SPDX-License-Identifier: Apache-2.0
#include <twum/motors/model_notes.hpp>

#include "file/drive_notes.hpp"

#include <twum/core/metrics.hpp>
#include <twum/core/parameters.hpp>
#include <twum/core/plate.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/number.hpp>
#include <twum/motors/curve_points.hpp>

#include <algorithm>
#include <cmath>

namespace twum::inline v0_1::motors {
namespace {

#ifndef __wasm__
constexpr double kTurn = 6.2831853071795865;  // 2 pi
#endif

// The box of docs/theory/contact-model.md, section 10, in which random motors are tested. A value of 0
// is a limit of the model that has tests of its own.
struct Range {
  Parameter parameter;
  double low;
  double high;
};

constexpr Range kTested[] = {
    {Parameter::wavelengths, 1, 30},
    {Parameter::contact_radius, 2e-3, 0.1},
    {Parameter::neutral_plane_distance, 0.2e-3, 10e-3},
    {Parameter::frequency, 20e3, 150e3},
    {Parameter::amplitude, 0.05e-6, 5e-6},
    {Parameter::thickness, 10e-6, 5e-3},
    {Parameter::youngs_modulus, 1e6, 500e9},
    {Parameter::density, 500, 8000},
    {Parameter::loss_factor, 0, 2},
    {Parameter::kinetic_friction, 0, 1},
};

// Compares with a tolerance, because a value typed like a limit may differ from it in the last bit.
bool outside(double value, double low, double high) {
  constexpr double kRounding = 1e-12;
  return value < low * (1 - kRounding) || value > high * (1 + kRounding);
}

void add_range(const MotorDesign& design, const Range& range, std::vector<ModelNote>& notes) {
  const double value = get(design, range.parameter);
  const bool stated = in_use(design, range.parameter) || range.parameter == Parameter::loss_factor;
  if (!stated || value == 0 || !outside(value, range.low, range.high)) return;
  const ParameterInfo& row = info(range.parameter);
  const auto shown = [&](double v) { return v == 0 ? "0" : engineering(v, row.unit); };
  const double off = value > range.high ? value / range.high : range.low / value;
  notes.push_back({std::string(row.name), off,
                   std::string(row.name) + " " + shown(value) + " is outside " + shown(range.low) +
                       " to " + shown(range.high) + ", where the solver is tested" +
                       (row.unit == "1" ? "" : " (is its unit right?)")});
}

void add_ratio(const std::string& topic, double ratio, double low, double high,
               const std::string& what, std::vector<ModelNote>& notes) {
  if (!std::isfinite(ratio) || ratio == 0 || !outside(ratio, low, high)) return;
  notes.push_back({topic, ratio > high ? ratio / high : low / ratio,
                   what + " is " + rounded_text(ratio, 3) + ", outside " + rounded_text(low, 2) +
                       " to " + rounded_text(high, 2) + ", where the solver is tested"});
}

void add_ratios(const MotorDesign& design, std::vector<ModelNote>& notes) {
  add_ratio("contact_width",
            get(design, Parameter::contact_width) / get(design, Parameter::contact_radius), 0.02,
            0.4, "contact_width / contact_radius", notes);
  add_ratio("static_friction",
            get(design, Parameter::static_friction) / get(design, Parameter::kinetic_friction), 1,
            2, "static_friction / kinetic_friction", notes);
}

void add_load(const Motor& motor, std::vector<ModelNote>& notes) {
  add_ratio("preload", motor.contact().load_ratio, 1e-6, 10,
            "preload in parts of that of full contact", notes);
}

void add_thick_layer(const MotorDesign& design, const Motor& motor, std::vector<ModelNote>& notes) {
  constexpr double kThin = 0.1;
  const double length = 2 * motor.contact().half_length;
  const double thickness = get(design, Parameter::thickness);
  const double part = thickness / length;
  if (std::isfinite(part) && part > kThin * (1 + 1e-9))  // without preload there is no contact
    notes.push_back({"thick layer", part,
                     "thickness " + engineering(thickness, "m") + " is " + about(100 * part) +
                         " % of the contact length " + engineering(length, "m") +
                         " (twice contact_half_length); the elastic-foundation "
                         "assumption holds up to about 10 %"});
}

void add_contact(const MotorDesign& design, const Motor& motor, std::vector<ModelNote>& notes) {
  constexpr double kClosed = 0.5;
  add_thick_layer(design, motor, notes);
  if (motor.crest_speed() > 0 && motor.contact().ratio >= kClosed)
    notes.push_back({"full contact", 0,
                     "the layer touches the stator all round (contact_ratio 0.5), which would "
                     "hinder a real wave"});
}

// The note on two similar modes of the stator, of which one was taken for the wave.
void add_modes(const MotorDesign& design, std::vector<ModelNote>& notes) {
  if (!design.stator.geometry) return;
  switch (plate_model(design, stator::OtherModes::none, stator::Derivatives::none)->identity) {
    case stator::ModeIdentity::clear: break;
    case stator::ModeIdentity::shared:
      notes.push_back(
          {"two modes of the stator", 0,
           "the stator has two modes with the wave's number of wavelengths that keep their "
           "sign on the ring, with modal masses within a factor of two; the lighter is taken "
           "for the wave, and it changes quickly with the geometry"});
      break;
    case stator::ModeIdentity::crossing:
      notes.push_back(
          {"two modes of the stator", 0,
           "two modes of the stator with the wave's number of wavelengths have the same "
           "frequency; metrics have no derivatives here, so change the web or the ring a "
           "little before a search starts from this motor"});
  }
}

#ifndef __wasm__  // of drawings, which a page only opens
// A wave needs three teeth to have a shape between them; with fewer the tips do not follow it.
void add_tooth_count(const MotorDesign& design, std::vector<ModelNote>& notes) {
  constexpr double kFewest = 3;
  const double n = design.stator.wavelengths, count = design.stator.geometry->teeth->count;
  if (count >= kFewest * n) return;
  notes.push_back(
      {"number of teeth", kFewest * n / count,
       "the stator has " + rounded_text(count / n, 3) +
           " teeth per wavelength; with fewer than 3 the tips of the teeth do not follow the "
           "wave, so take at least " +
           rounded_text(kFewest * n, 6) + " teeth"});
}

// First bending frequency of a tooth that stands on a rigid ring: a cantilever of width b and height h has
// 1.8751^2 / (2 pi sqrt(12)) (b / h^2) sqrt(E / rho).
double tooth_frequency(const stator::StatorGeometry& g, double width) {
  constexpr double kCantilever = 0.16154;
  const double height = g.teeth->height;
  return kCantilever * width / (height * height) *
         std::sqrt(g.substrate.youngs_modulus / g.substrate.density);
}

// Teeth move as rigid bodies in the model of the plate.
void add_tooth_width(const MotorDesign& design, std::vector<ModelNote>& notes) {
  constexpr double kRigid = 3;  // a tooth then bends by a ninth of what it moves
  const stator::StatorGeometry& g = *design.stator.geometry;
  const double width = kTurn * g.teeth->inner_radius / g.teeth->count - g.teeth->slot_width;
  const double own = tooth_frequency(g, width), driven = drive_frequency(design);
  if (!(own < kRigid * driven)) return;
  notes.push_back(
      {"width of the teeth", kRigid * driven / own,
       "the teeth are " + engineering(width, "m") + " wide at their inner radius and " +
           engineering(g.teeth->height, "m") + " high, and would bend by themselves at " +
           engineering(own, "Hz") +
           "; below three times the drive frequency they are not rigid, as the plate model "
           "has them: make them wider or lower, or compare with 'twum stator --solid'"});
}

void add_teeth(const MotorDesign& design, std::vector<ModelNote>& notes) {
  if (!design.stator.geometry || !design.stator.geometry->teeth) return;
  add_tooth_count(design, notes);
  add_tooth_width(design, notes);
}
#endif

// Relative changes of metrics from one model to another that matter, in words, and the largest.
struct Changes {
  std::string text;
  double worst{0};
};

struct ComparedMetric {
  std::string name;
  MetricRequest request;
};

Changes changes(const Motor& before, const Motor& after,
                const std::vector<ComparedMetric>& compared, double least) {
  Changes found;
  for (const ComparedMetric& one : compared) {
    const MetricValue from = evaluate(before, one.request), to = evaluate(after, one.request);
    const bool known = from.status == MetricStatus::ok && to.status == MetricStatus::ok;
    const double by = known && from.value != 0 ? to.value / from.value - 1 : 0;
    if (!known || std::fabs(by) < least) continue;
    found.worst = std::max(found.worst, std::fabs(by));
    found.text +=
        (found.text.empty() ? "" : ", ") + one.name + " by " + rounded_text(100 * by, 2) + " %";
  }
  return found;
}

ComparedMetric plain(Metric metric) {
  return {std::string(info(metric).name), {metric, Argument::none, 0}};
}

// Where the torque of each wave may jump, the largest power takes seconds.
bool has_quick_peak(const MotorDesign& design) {
  return !(design.stator.voltage && design.friction.threshold > design.friction.kinetic);
}

// All of one slice slides alike, so that nearly nothing wears at light load.
void add_wear(const MotorDesign& design, std::vector<ModelNote>& notes) {
  if (!design.wear || design.stator.radial_slices != 1) return;
  notes.push_back({"wear with one slice", 0,
                   "rates of wear and lives are not valid with one slice, which leaves out the "
                   "sliding across the width of the track: a half to a thirteenth of the wear of "
                   "the example drive-60; write 'radial_slices: auto'"});
}

// What one slice leaves out.
void add_width(const MotorDesign& design, std::vector<ModelNote>& notes) {
  constexpr double kMatters = 0.02;
  constexpr int kSlices = 8;
  MotorDesign wide = design;
  wide.stator.radial_slices = kSlices;
  if (design.stator.radial_slices != 1 || !complaints(wide).empty()) return;
  std::vector<ComparedMetric> compared{plain(Metric::stall_torque), plain(Metric::no_load_speed)};
  if (has_quick_peak(design)) compared.push_back(plain(Metric::peak_power));
  const Changes found = changes(Motor(design), Motor(wide), compared, kMatters);
  if (found.text.empty()) return;
  notes.push_back(
      {"width of the contact", found.worst,
       "the width of the contact and the wave's radial shape, which one slice leaves out, "
       "change " +
           found.text + "; write 'radial_slices: auto' to include them"});
}

#ifndef __wasm__
// What a surface that moves along the circumference only leaves out, on a few slices of the track.
void add_radial_motion(const MotorDesign& design, std::vector<ModelNote>& notes) {
  constexpr double kSmall = 0.1;
  constexpr int kSlices = 4;
  MotorDesign without = design, with_it = design;
  with_it.stator.radial_motion = true;
  if (design.stator.radial_motion || !complaints(with_it).empty()) return;
  if (design.stator.radial_slices != 1)
    without.stator.radial_slices = with_it.stator.radial_slices = kSlices;
  const Motor before(without);
  const MetricValue ratio = evaluate(before, {Metric::radial_motion_ratio});
  const MetricValue no_load = evaluate(before, {Metric::no_load_speed});
  if (!(ratio.value > kSmall) || no_load.status != MetricStatus::ok) return;
  std::vector<ComparedMetric> compared{
      {"torque at half no-load speed", {Metric::torque_at, Argument::speed, 0.5 * no_load.value}}};
  if (has_quick_peak(design)) {
    compared.insert(compared.begin(), plain(Metric::peak_power));
    compared.push_back(plain(Metric::contact_efficiency_at_peak_power));
  }
  if (design.stator.voltage) compared.push_back(plain(Metric::start_voltage));
  if (design.wear)
    compared.push_back({"wear at half no-load speed",
                        {Metric::wear_intensity_at, Argument::speed, 0.5 * no_load.value}});
  const Changes found = changes(before, Motor(with_it), compared, 0);
  if (found.text.empty()) return;
  notes.push_back({"radial motion", ratio.value,
                   "the surface also moves radially, by " + rounded_text(ratio.value, 2) +
                       " of its motion along the track, which is left out: it changes " +
                       found.text + "; 'radial_motion: true' under stator includes it"});
}
#endif

// The speeds up to no-load at which a free backward wave grows, where that is known (D6.8).
struct SquealSpeeds {
  double fastest{-1};  // largest such speed; negative if there is none [rad/s]
  double fed{0};       // largest fed_damping there [N s/m]
  double rate{0};      // largest, where it is known [1/s]
};

// Looks at equal distances; beyond the last that squeals, the end is found by halving.
SquealSpeeds squeal_speeds(const Motor& motor, double no_load) {
  constexpr int kLooks = 16;
  constexpr int kHalvings = 10;  // leave 6e-5 of the no-load speed, a unit of the last digit shown
  SquealSpeeds found;
  const auto squeals_at = [&](double speed) {
    const BackwardWave wave = motor.backward_wave(speed);
    if (!squeals(motor.design(), wave).value_or(false)) return false;
    found = {std::fmax(found.fastest, speed), std::fmax(found.fed, wave.fed_damping),
             std::fmax(found.rate, wave.squeal_rate)};
    return true;
  };
  const double step = no_load / kLooks;
  for (int i = 0; i < kLooks; ++i) squeals_at(i * step);
  if (found.fastest < 0) return found;
  double quiet = found.fastest + step;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = 0.5 * (found.fastest + quiet);
    if (!squeals_at(middle)) quiet = middle;
  }
  return found;
}

void add_squeal(const Motor& motor, std::vector<ModelNote>& notes) {
  const MetricValue no_load = evaluate(motor, {Metric::no_load_speed});
  if (no_load.status != MetricStatus::ok) return;
  const bool modal = has_modal_data(motor.design());
  const double given = modal_damping(motor.design()), damping = given > 0 ? given : 0;
  const SquealSpeeds squeal = squeal_speeds(motor, no_load.value);
  if (squeal.fastest < 0) return;
  const auto in_words = [](double d) { return rounded_text(d, 4) + " N.s/m"; };
  const std::string cause =
      modal ? "friction lets a backward wave grow by up to " + rounded_text(squeal.rate, 4) +
                  " 1/s (squeal_rate_at)"
            : "friction feeds a backward wave with up to " + in_words(squeal.fed) +
                  (damping > 0 ? ", more than the modal_damping of " + in_words(damping)
                               : ", and modal_damping is not given");
  notes.push_back(
      {"squeal", modal ? squeal.rate : squeal.fed,
       "the motor squeals under load at speeds up to " + engineering(squeal.fastest, "rad/s") +
           ": " + cause +
           "; a heavy rotor then loses up to half of the torque, which is not computed"});
}

}  // namespace

std::vector<ModelNote> model_notes(const MotorDesign& design) { return model_notes(Motor(design)); }

std::vector<ModelNote> model_notes(const Motor& motor) {
  const MotorDesign& design = motor.design();
  std::vector<ModelNote> notes;
  for (const Range& range : kTested) add_range(design, range, notes);
  add_ratios(design, notes);
  add_load(motor, notes);
  add_contact(design, motor, notes);
  add_modes(design, notes);
  add_wear(design, notes);
#ifndef __wasm__
  add_teeth(design, notes);
#endif
  if (!motor.slices_settled())
    notes.push_back(
        {"slices", 0,
         "radial_slices auto found no number of slices that is accurate to 1e-6 and takes " +
             std::to_string(std::abs(motor.radial_slices())) +
             "; compare with 'radial_slices: 64' before you rely on the third digit"});
  return notes;
}

std::string tested_range_note(const MotorDesign& design, Parameter parameter) {
  std::vector<ModelNote> notes;
  for (const Range& range : kTested) add_range(design, range, notes);
  add_ratios(design, notes);
  if (parameter == Parameter::preload) add_load(Motor(design), notes);
  const auto note = std::find_if(notes.begin(), notes.end(), [&](const ModelNote& one) {
    return one.topic == info(parameter).name;
  });
  return note == notes.end() ? std::string() : note->text;
}

std::string thick_layer_note(const MotorDesign& design) {
  std::vector<ModelNote> notes;
  add_thick_layer(design, Motor(design), notes);
  return notes.empty() ? std::string() : notes.front().text;
}

std::vector<ModelNote> model_notes_at_length(const MotorDesign& design) {
  const Motor motor(design);
  std::vector<ModelNote> notes = model_notes(motor);
  if (const auto drive = drive_note(motor)) notes.push_back(*drive);
  add_squeal(motor, notes);
  add_width(design, notes);
#ifndef __wasm__  // the page cannot compute it
  add_radial_motion(design, notes);
#endif
  return notes;
}

}  // namespace twum::inline v0_1::motors
