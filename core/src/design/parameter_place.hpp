// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "design/plate_numbers.hpp"

#include <twum/base/no_value.hpp>
#include <twum/core/motor_design.hpp>
#include <twum/stator/geometry.hpp>

#include <optional>
#include <type_traits>

/// How a design holds its parameters: the functions in the rows of the parameter table.
namespace twum::inline v0_1 {

/// Where a design holds one parameter.
struct ParameterPlace {
  double (*get)(const MotorDesign&);  ///< as get(); a plate's number of a design without a geometry
  bool (*in_use)(const MotorDesign&);  ///< as in_use(), likewise; null: where get() has a value
  bool (*set)(MotorDesign&, double);   ///< removes the alternative; false if its block is missing
  std::optional<PlateNumber> plate{};  ///< what gives it where the design has a geometry
  std::optional<stator::Dimension> dimension{};  ///< of the plate that moves with it
  bool (*in_reserve)(const MotorDesign&){
      nullptr};  ///< true if a value that is not in use may come into use

  constexpr ParameterPlace used_if(bool (*condition)(const MotorDesign&)) const {
    ParameterPlace place = *this;
    place.in_use = condition;
    return place;
  }
  constexpr ParameterPlace read_by(double (*reader)(const MotorDesign&)) const {
    ParameterPlace place = *this;
    place.get = reader;
    return place;
  }
  constexpr ParameterPlace set_by(bool (*setter)(MotorDesign&, double)) const {
    ParameterPlace place = *this;
    place.set = setter;
    return place;
  }
  constexpr ParameterPlace given_by(PlateNumber number) const {
    ParameterPlace place = *this;
    place.plate = number;
    return place;
  }
  constexpr ParameterPlace moving(stator::Dimension number) const {
    ParameterPlace place = *this;
    place.dimension = number;
    return place;
  }
  constexpr ParameterPlace kept_if(bool (*condition)(const MotorDesign&)) const {
    ParameterPlace place = *this;
    place.in_reserve = condition;
    return place;
  }
};

/// @name The block of a design that holds a member
/// @{
template <typename Block>
struct BlockOf;
template <typename Block, typename Number>
struct BlockOf<Number Block::*> {
  using type = Block;
};

template <typename Block, typename Design>
auto& block_in(Design& design) {
  if constexpr (std::is_same_v<Block, Stator>) return design.stator;
  if constexpr (std::is_same_v<Block, RadialShape>) return design.stator.radial_shape;
  if constexpr (std::is_same_v<Block, ContactLayer>) return design.layer;
  if constexpr (std::is_same_v<Block, Friction>) return design.friction;
  if constexpr (std::is_same_v<Block, Rotor>) return design.rotor;
  if constexpr (std::is_same_v<Block, MotorDesign>) return design;
}

template <auto member, typename Design>
auto& number_in(Design& design) {
  return block_in<typename BlockOf<decltype(member)>::type>(design).*member;
}
/// @}

inline bool always(const MotorDesign&) { return true; }

/// True if an optional member is given.
template <auto member>
bool has(const MotorDesign& design) {
  return number_in<member>(design).has_value();
}
template <auto member>
bool lacks(const MotorDesign& design) {
  return !has<member>(design);
}

template <auto member>
bool assign(MotorDesign& design, double value) {
  auto& number = number_in<member>(design);
  if constexpr (std::is_same_v<std::decay_t<decltype(number)>, int>)
    number = static_cast<int>(value);
  else
    number = value;
  return true;
}

/// Sets a number and removes the optional one that states the same.
template <auto member, auto alternative>
bool assign_instead_of(MotorDesign& design, double value) {
  number_in<alternative>(design).reset();
  return assign<member>(design, value);
}

/// A number that every design has.
template <auto member>
constexpr ParameterPlace plain() {
  return {[](const MotorDesign& d) -> double { return number_in<member>(d); }, always,
          assign<member>};
}

/// A number that a design may have.
template <auto member>
constexpr ParameterPlace optional_number() {
  return {[](const MotorDesign& d) { return number_in<member>(d).value_or(kNoValue); }, has<member>,
          assign<member>};
}

/// A number that an optional one replaces.
template <auto member, auto alternative>
constexpr ParameterPlace unless_given() {
  return {[](const MotorDesign& d) -> double { return number_in<member>(d); }, lacks<alternative>,
          assign_instead_of<member, alternative>};
}

/// A number of a block that a design may have; its value there, or that of a default block.
template <auto block, auto member>
constexpr ParameterPlace in_block() {
  return {[](const MotorDesign& d) -> double {
            using Block = typename BlockOf<decltype(member)>::type;
            return (number_in<block>(d).value_or(Block{}).*member);
          },
          has<block>,
          [](MotorDesign& d, double value) {
            auto& held = number_in<block>(d);
            if (!held) held.emplace();
            (*held).*member = value;
            return true;
          }};
}

}  // namespace twum::inline v0_1
