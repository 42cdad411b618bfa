// SPDX-License-Identifier: Apache-2.0
#include <twum/core/plate.hpp>

#include "design/plate_numbers.hpp"

#include <twum/base/error.hpp>
#include <twum/base/once.hpp>

#include <algorithm>
#include <array>
#include <memory>
#include <utility>

namespace twum::inline v0_1 {

using stator::Derivatives;
using stator::OtherModes;
using stator::StatorModel;

// Hidden: templates of the standard library with its functions are otherwise visible in each program that links the library.
struct [[gnu::visibility("hidden")]] SolvedPlate::Known {
  /// Everything that determines the numbers of a plate.
  struct Input {
    stator::StatorGeometry geometry;
    double wavelengths, contact_radius, contact_width;

    bool operator==(const Input&) const = default;
  };
  using Model = std::shared_ptr<const StatorModel>;

  explicit Known(Input asked) : input(std::move(asked)), stator(solved(input)) {}

  const Model& wave(Derivatives derivatives) const {
    return waves[static_cast<std::size_t>(derivatives)].get(
        [&] { return std::make_shared<const StatorModel>(stator.wave(derivatives)); });
  }
  const stator::Derived& separation(Derivatives derivatives) const {
    return separations[static_cast<std::size_t>(derivatives)].get(
        [&] { return stator.mode_separation(derivatives); });
  }
  const Model& whole() const {
    return all.get([&] {
      auto model = std::make_shared<StatorModel>(*wave(Derivatives::all));
      model->mode_separation = separation(Derivatives::all);
      model->unwanted = stator.unwanted();
      return Model(std::move(model));
    });
  }

  static stator::SolvedStator solved(const Input& input) {
    std::array<double, kShapePoints.size() + 2> offsets{};
    const double half = 0.5 * input.contact_width;
    std::transform(kShapePoints.begin(), kShapePoints.end(), offsets.begin(),
                   [=](double point) { return half * point; });
    offsets[kShapePoints.size()] = -half, offsets.back() = half;
    return {input.geometry, static_cast<int>(input.wavelengths), input.contact_radius,
            stator::PlateTheory::mindlin, offsets};
  }

  Input input;
  stator::SolvedStator stator;
  std::array<Once<Model>, 2> waves{};  // without derivatives, and with them
  std::array<Once<stator::Derived>, 2> separations{};
  Once<Model> all{};  // with the modes beside the wave
};

namespace {

using Known = SolvedPlate::Known;
using PlateInput = Known::Input;

PlateInput plate_input(const MotorDesign& design) {
  const Stator& s = design.stator;
  if (!s.geometry) throw InputError("geometry must be given for a plate, but is not");
  return {*s.geometry, s.wavelengths, s.contact_radius, s.contact_width};
}

bool is_of(const PlateInput& input, const SolvedPlate& plate) {
  return plate.known && plate.known->input == input;
}

// That of the design, or one solved for this call.
std::shared_ptr<const Known> known_plate(const MotorDesign& design) {
  PlateInput input = plate_input(design);
  if (is_of(input, design.stator.plate)) return design.stator.plate.known;
  return std::make_shared<const Known>(std::move(input));
}

}  // namespace

std::shared_ptr<const StatorModel> plate_model(const MotorDesign& design, OtherModes others,
                                               Derivatives derivatives) {
  const auto known = known_plate(design);
  return others == OtherModes::none ? known->wave(derivatives) : known->whole();
}

stator::Derived plate_separation(const MotorDesign& design, Derivatives derivatives) {
  return known_plate(design)->separation(derivatives);
}

void keep_plate(MotorDesign& design) {
  if (!design.stator.geometry) return;
  PlateInput input = plate_input(design);
  if (is_of(input, design.stator.plate)) return;
  design.stator.plate = {};
  try {
    design.stator.plate.known = std::make_shared<const Known>(std::move(input));
  } catch (const Error&) {  // no plate: whoever needs it says why
  }
}

}  // namespace twum::inline v0_1
