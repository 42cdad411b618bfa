// SPDX-License-Identifier: Apache-2.0
#include <twum/core/plate.hpp>

#include "design/plate_numbers.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <deque>

namespace twum {
namespace {

using stator::StatorModel;

// Everything that determines the numbers of a plate.
struct PlateInput {
  stator::StatorGeometry geometry;
  double wavelengths, contact_radius, contact_width;

  bool operator==(const PlateInput&) const = default;
};

struct KnownPlate {
  PlateInput input;
  std::shared_ptr<const StatorModel> model;
};

// A search uses few plates at a time: that of the current design and those of its neighbours.
constexpr std::size_t kKeptPlates = 8;

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

}  // namespace

std::shared_ptr<const StatorModel> plate_model(const MotorDesign& design,
                                               stator::OtherModes others) {
  thread_local std::deque<KnownPlate>
      kept;  // numbers follow from the input alone, whichever thread asks
  PlateInput input = plate_input(design);
  const auto known = std::find_if(kept.begin(), kept.end(),
                                  [&](const KnownPlate& one) { return one.input == input; });
  const bool missing = others == stator::OtherModes::found;
  if (known != kept.end() && !(missing && known->model->unwanted.empty())) return known->model;
  auto model = solved_plate(input, others);
  if (known != kept.end()) {
    known->model = model;
    return model;
  }
  if (kept.size() == kKeptPlates) kept.pop_back();
  kept.push_front({std::move(input), model});
  return model;
}

}  // namespace twum
