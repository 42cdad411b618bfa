// SPDX-License-Identifier: Apache-2.0
#include <twum/core/plate.hpp>

#include "design/plate_numbers.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <atomic>
#include <memory>
#include <utility>

namespace twum {

struct SolvedPlate::Known {
  /// Everything that determines the numbers of a plate.
  struct Input {
    stator::StatorGeometry geometry;
    double wavelengths, contact_radius, contact_width;

    bool operator==(const Input&) const = default;
  };
  using Model = std::shared_ptr<const stator::StatorModel>;

  Known(Input solved_for, Model solved) : input(std::move(solved_for)), wave(std::move(solved)) {}
  ~Known() { delete whole.load(); }
  Known(const Known&) = delete;
  Known& operator=(const Known&) = delete;

  Input input;
  Model wave;                                        // without the modes beside the wave
  mutable std::atomic<const Model*> whole{nullptr};  // with them, once they were needed
};

namespace {

using stator::StatorModel;
using PlateInput = SolvedPlate::Known::Input;

PlateInput plate_input(const MotorDesign& design) {
  const Stator& s = design.stator;
  if (!s.geometry) throw InputError("geometry must be given for a plate, but is not");
  return {*s.geometry, s.wavelengths, s.contact_radius, s.contact_width};
}

std::shared_ptr<const StatorModel> solved_plate(const PlateInput& input,
                                                stator::OtherModes others) {
  std::array<double, kShapePoints.size() + 2> offsets{};
  const double half = 0.5 * input.contact_width;
  std::transform(kShapePoints.begin(), kShapePoints.end(), offsets.begin(),
                 [=](double point) { return half * point; });
  offsets[kShapePoints.size()] = -half, offsets.back() = half;
  return std::make_shared<const StatorModel>(stator::stator_model(
      input.geometry, static_cast<int>(input.wavelengths), input.contact_radius,
      stator::PlateTheory::mindlin, stator::Derivatives::all, offsets, others));
}

using Known = SolvedPlate::Known;

bool is_of(const PlateInput& input, const SolvedPlate& plate) {
  return plate.known && plate.known->input == input;
}

// Two threads that ask at once both solve, and find the same.
Known::Model with_other_modes(const Known& known) {
  if (const Known::Model* whole = known.whole.load()) return *whole;
  auto mine =
      std::make_unique<const Known::Model>(solved_plate(known.input, stator::OtherModes::found));
  const Known::Model* first = nullptr;
  return known.whole.compare_exchange_strong(first, mine.get()) ? *mine.release() : *first;
}

}  // namespace

std::shared_ptr<const StatorModel> plate_model(const MotorDesign& design,
                                               stator::OtherModes others) {
  const PlateInput input = plate_input(design);
  const SolvedPlate& plate = design.stator.plate;
  if (!is_of(input, plate)) return solved_plate(input, others);
  return others == stator::OtherModes::none ? plate.known->wave : with_other_modes(*plate.known);
}

void keep_plate(MotorDesign& design) {
  if (!design.stator.geometry) return;
  PlateInput input = plate_input(design);
  if (is_of(input, design.stator.plate)) return;
  design.stator.plate = {};
  try {
    auto wave = solved_plate(input, stator::OtherModes::none);
    design.stator.plate.known = std::make_shared<const Known>(std::move(input), std::move(wave));
  } catch (const Error&) {  // no plate: whoever needs it says why
  }
}

}  // namespace twum
