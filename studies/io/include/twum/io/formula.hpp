// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/base/namespaces.hpp>
#include <twum/io/dimension.hpp>

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace twum::inline v0_1::io {

/// A name in a formula.
struct FormulaName {
  std::string text;       ///< its canonical text, such as "torque_at(100 rpm)"
  Dimension dimension;    ///< of its value
  std::size_t number{0};  ///< index of its value among the arguments of Formula::value()
};

/// The names that a formula may hold.
struct FormulaNames {
  /// Reads a name with its argument in parentheses, such as "torque_at(100 rpm)". `whole_text` is true if the formula
  /// is this name only.
  /// @throws ValueError with the position in the reference
  std::function<FormulaName(std::string_view reference, bool whole_text)> read;
  /// what an error asks for where a name is missing, such as "expected a metric such as 'stall_torque'"
  std::string expected;
};

/// Value of a formula and its derivatives with respect to each name.
struct FormulaDerivative {
  double value{0};              ///< SI; NaN where the formula is not defined
  std::vector<double> by_name;  ///< in the order of the names' numbers; NaN where there is none
  /// at a kink of abs, min or max; the derivatives are those of the branch of the value
  bool kinked{false};
};

/// A formula over named quantities: numbers with units, names, + - * / ^, parentheses, sqrt, abs, exp, log (natural), min and
/// max of two. Dimensions were checked when it was read, so evaluation is arithmetic with SI numbers. Constant, and safe
/// from any number of threads.
class Formula {
 public:
  /// What one step of the evaluation does.
  enum class Operation : unsigned char {
    number,
    name,
    negate,
    add,
    subtract,
    multiply,
    divide,
    power,
    sqrt,
    abs,
    exp,
    log,
    min,
    max
  };

  /// One step; operands are earlier steps.
  struct Step {
    Operation operation{};  ///< what is done
    std::size_t left{0};    ///< first operand; number of a name
    std::size_t right{0};   ///< second operand
    double value{0};        ///< of a constant step, SI
    bool constant{false};   ///< it depends on no name
  };

  /// The constant 0.
  Formula() : Formula({{Operation::number, 0, 0, 0, true}}, "0", {}) {}
  /// A formula of steps in the order of evaluation. The last step is the result.
  Formula(std::vector<Step> steps, std::string text, Dimension dimension);

  /// The canonical text, with normalized blanks and parentheses. Reading it gives the same formula.
  const std::string& text() const noexcept { return text_; }
  /// Of its value.
  const Dimension& dimension() const noexcept { return dimension_; }
  /// True if it contains no name; then value({}) is its value.
  bool constant() const noexcept { return steps_.back().constant; }
  /// True if it is a name and nothing else.
  bool is_name() const noexcept { return steps_.size() == 1 && !constant(); }

  /// Value, SI; NaN if a step is not defined: a quotient by zero, sqrt or log of a negative number, a number too
  /// large.
  double value(std::span<const double> names) const;
  /// Value and exact derivatives (reverse mode), in about twice the time of the value. `kinked` is set where the
  /// branches of min, max or abs differ by less than 1e-9 of the size of their arguments.
  FormulaDerivative differentiate(std::span<const double> names) const;

 private:
  std::vector<double> values(std::span<const double> names) const;

  std::vector<Step> steps_;
  std::string text_;
  Dimension dimension_;
};

/// Reads a formula. A unit follows its number and extends to the next blank, bracket or comma: "5 W/h" is five watts
/// per hour, "5 W / frequency" divides. "^" has precedence over a sign and is right-associative.
/// @throws ValueError with the position in the text: what was found and what would be right
Formula read_formula(std::string_view text, const FormulaNames& names);

/// Checks that the formulas on both sides of a sign such as ">=" have the same dimension.
/// @throws ValueError that names both dimensions, with the position of the sign, if they differ
void require_same_dimension(const Formula& left, const Formula& right, std::string_view sign,
                            std::size_t position);

}  // namespace twum::inline v0_1::io
