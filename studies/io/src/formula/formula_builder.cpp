// SPDX-License-Identifier: Apache-2.0
#include "formula/formula_builder.hpp"

#include "formula/operations.hpp"

#include <twum/io/units.hpp>
#include <twum/io/value_error.hpp>
#include <twum/io/words.hpp>

#include <cmath>
#include <utility>

namespace twum::inline v0_1::io {
namespace {

using Operation = Formula::Operation;

constexpr std::size_t kMostSteps = 1000;  // limit of steps in a formula

const char* name_of(Operation operation) {
  switch (operation) {
    case Operation::number:
    case Operation::name: return "";
    case Operation::negate:
    case Operation::subtract: return "-";
    case Operation::add: return "+";
    case Operation::multiply: return "*";
    case Operation::divide: return "/";
    case Operation::power: return "^";
    case Operation::sqrt: return "sqrt";
    case Operation::abs: return "abs";
    case Operation::exp: return "exp";
    case Operation::log: return "log";
    case Operation::min: return "min";
    case Operation::max: return "max";
  }
  return "";
}

std::string measured(const std::string& text, const Dimension& dimension) {
  return io::quoted(text) + " is " + dimension_phrase(dimension.unit());
}

// The text of an operand, in parentheses if its precedence is lower than required.
std::string operand(const FormulaPart& part, Binding least) {
  return part.binding < least ? "(" + part.text + ")" : part.text;
}

Binding binding_of(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract: return Binding::sum;
    case Operation::multiply:
    case Operation::divide: return Binding::product;
    case Operation::negate: return Binding::sign;
    case Operation::power: return Binding::power;
    default: return Binding::atom;
  }
}

// "a + b", "a^b", "max(a, b)", with the parentheses that keep the order of the steps.
std::string text_of(Operation operation, const FormulaPart& left, const FormulaPart& right) {
  const std::string sign = name_of(operation);
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
      return operand(left, Binding::sum) + " " + sign + " " + operand(right, Binding::product);
    case Operation::multiply:
    case Operation::divide:
      return operand(left, Binding::product) + " " + sign + " " + operand(right, Binding::sign);
    case Operation::power:
      return operand(left, Binding::atom) + sign + operand(right, Binding::sign);
    default: return sign + "(" + left.text + ", " + right.text + ")";
  }
}

void refuse_difference(const std::string& left, const Dimension& of_left, const std::string& right,
                       const Dimension& of_right, std::string_view sign, std::size_t at) {
  if (of_left == of_right) return;
  const bool angle = of_left.differs_by_angle_only(of_right);
  throw ValueError(measured(left, of_left) + ", but " + measured(right, of_right),
                   io::quoted(sign) + " needs the same dimension on both sides" +
                       (angle ? "; these differ by an angle: multiply or divide by '1 rad'" : ""),
                   at);
}

void require_number(Operation operation, const FormulaPart& part, std::size_t at) {
  if (part.dimension.none()) return;
  throw ValueError(measured(part.text, part.dimension),
                   std::string(name_of(operation)) +
                       " takes a number without unit; divide by a reference value such as '1 " +
                       part.dimension.unit() + "'",
                   at);
}

}  // namespace

void require_same_dimension(const Formula& left, const Formula& right, std::string_view sign,
                            std::size_t position) {
  refuse_difference(left.text(), left.dimension(), right.text(), right.dimension(), sign, position);
}

// Appends a step. A constant step is evaluated at once.
FormulaPart FormulaBuilder::add(Formula::Step step, std::string text, Binding binding,
                                const Dimension& dimension, std::size_t at) {
  if (steps_.size() == kMostSteps)
    throw ValueError("more than 1000 operations", "write a shorter expression", at);
  if (step.operation != Operation::name && step.operation != Operation::number) {
    const Formula::Step& left = steps_[step.left];
    const Formula::Step& right = steps_[step.right];
    step.constant = left.constant && right.constant;
    if (step.constant) step.value = apply(step.operation, left.value, right.value);
  }
  if (step.constant && !std::isfinite(step.value))
    throw ValueError(io::quoted(text) + " has no finite value", "correct this part", at);
  steps_.push_back(step);
  return {steps_.size() - 1, std::move(text), binding, dimension};
}

FormulaPart FormulaBuilder::number(const Measure& measure, std::string text) {
  const bool bare = text.find(' ') == std::string::npos;
  return add({Operation::number, 0, 0, measure.value, true}, std::move(text),
             bare ? Binding::atom : Binding::quantity, measure.dimension, 0);
}

FormulaPart FormulaBuilder::name(const FormulaName& name) {
  return add({Operation::name, name.number, 0, 0, false}, name.text, Binding::atom, name.dimension,
             0);
}

// The dimension of a power is known only if the exponent is.
Dimension FormulaBuilder::power_dimension(const FormulaPart& base, const FormulaPart& exponent,
                                          std::size_t at) const {
  if (!exponent.dimension.none())
    throw ValueError(measured(exponent.text, exponent.dimension),
                     "an exponent is a number without unit", at);
  if (base.dimension.none()) return {};
  const Formula::Step& step = steps_[exponent.step];
  if (!step.constant)
    throw ValueError(
        measured(base.text, base.dimension) + " with the exponent " + io::quoted(exponent.text),
        "a quantity with a unit takes a number as its exponent", at);
  constexpr double kMostPower = 1000;  // limit of the powers in a dimension
  if (std::fabs(step.value) > kMostPower)
    throw ValueError("the exponent " + io::quoted(exponent.text) + " is too large",
                     "a quantity with a unit takes an exponent up to 1000", at);
  return base.dimension.power(step.value);
}

Dimension FormulaBuilder::dimension_of(Operation operation, const FormulaPart& left,
                                       const FormulaPart& right, std::size_t at) const {
  switch (operation) {
    case Operation::multiply: return left.dimension.times(right.dimension);
    case Operation::divide: return left.dimension.over(right.dimension);
    case Operation::power: return power_dimension(left, right, at);
    default:
      refuse_difference(left.text, left.dimension, right.text, right.dimension, name_of(operation),
                        at);
      return left.dimension;
  }
}

FormulaPart FormulaBuilder::binary(Operation operation, const FormulaPart& left,
                                   const FormulaPart& right, std::size_t at) {
  const Dimension dimension = dimension_of(operation, left, right, at);
  return add({operation, left.step, right.step, 0, false}, text_of(operation, left, right),
             binding_of(operation), dimension, at);
}

FormulaPart FormulaBuilder::unary(Operation operation, const FormulaPart& operand_,
                                  std::size_t at) {
  Dimension dimension = operand_.dimension;
  if (operation == Operation::sqrt) dimension = dimension.power(0.5);
  if (operation == Operation::exp || operation == Operation::log)
    require_number(operation, operand_, at);
  const std::string text = operation == Operation::negate
                               ? "-" + operand(operand_, Binding::sign)
                               : std::string(name_of(operation)) + "(" + operand_.text + ")";
  return add({operation, operand_.step, operand_.step, 0, false}, text, binding_of(operation),
             dimension, at);
}

Formula FormulaBuilder::finish(const FormulaPart& part) && {
  return {std::move(steps_), part.text, part.dimension};
}

}  // namespace twum::inline v0_1::io
