// SPDX-License-Identifier: Apache-2.0
#include "wasm/src/page_plant.hpp"

#include "motion/plant/plant_data.hpp"

#include <twum/base/error.hpp>

#include <algorithm>
#include <cmath>
#include <exception>
#include <limits>

namespace twum::inline v0_1::wasm {
namespace {

constexpr int kNeighbours = 4;  // rows, and columns, that are read at once

PlantContact pointers(const std::array<std::vector<float>, 3>& side) {
  return {side[0].data(), side[1].data(), side[2].data()};
}

}  // namespace

PagePlant::PagePlant(const MotorDesign& design)
    : nodes_(design, {}),
      data_(motion::plant_data(design, nodes_.frame())),
      inputs_(motion::plant_inputs(nodes_.frame())),
      parameters_(motion::plant_parameters(nodes_.frame())),
      state_(plant_at_rest()) {
  const auto size = static_cast<std::size_t>(data_.amplitudes * data_.speed_ratios);
  for (Side* side : {&along_, &against_})
    for (std::vector<float>& table : *side)
      table.assign(size, std::numeric_limits<float>::quiet_NaN());
  data_.along = pointers(along_), data_.against = pointers(against_);
  data_.before_reading = &before_reading, data_.filler = this;
}

double PagePlant::longest_step() const { return PLANT_PERIODS_PER_STEP / data_.frequency; }

double PagePlant::amplitude() const { return std::hypot(state_.zeta_real, state_.zeta_imaginary); }

void PagePlant::follow(double load_torque, bool enabled, double duration) {
  inputs_.load_torque = load_torque, inputs_.enabled = enabled ? 1 : 0;
  const char* wrong = plant_advance(&data_, &state_, &inputs_, &parameters_, duration);
  if (failure_.empty() && wrong != nullptr) failure_ = wrong;
  if (!failure_.empty()) throw InputError(failure_);
}

// The stepper is C, through which nothing is thrown.
void PagePlant::before_reading(void* filler, int along, int row, int column) {
  PagePlant& plant = *static_cast<PagePlant*>(filler);
  Side& side = along != 0 ? plant.along_ : plant.against_;
  const int rows = std::min(row + kNeighbours, plant.data_.speed_ratios);
  const int columns = std::min(column + kNeighbours, plant.data_.amplitudes);
  try {
    for (int i = std::max(row, 0); i < rows; ++i)
      for (int j = std::max(column, 0); j < columns; ++j)
        plant.solve_node(side, along != 0 ? 1 : -1, static_cast<std::size_t>(i),
                         static_cast<std::size_t>(j));
  } catch (const std::exception& error) {
    plant.failure_ = error.what();
  }
}

void PagePlant::solve_node(Side& side, double sign, std::size_t row, std::size_t column) {
  const std::size_t place = row * static_cast<std::size_t>(data_.amplitudes) + column;
  if (!std::isnan(side[0][place])) return;
  const motion::ContactForces f = nodes_.at(column, row, sign);
  if (!f.known) failure_ = "the contact has no answer: " + nodes_.failure();
  side[0][place] = static_cast<float>(f.torque);
  side[1][place] = static_cast<float>(f.stiffness.real());
  side[2][place] = static_cast<float>(f.stiffness.imag());
}

}  // namespace twum::inline v0_1::wasm
