// SPDX-License-Identifier: Apache-2.0
#include "units/unit_system.hpp"

#include "text/utf8.hpp"
#include "units/unit_definitions.hpp"
#include "units/unit_spelling.hpp"

#include <twum/base/error.hpp>

#include <udunits2.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <memory>
#include <mutex>

namespace twum::inline v0_1::io {
namespace {

struct FreeUnit {
  void operator()(ut_unit* unit) const { ut_free(unit); }
};
using UnitPointer = std::unique_ptr<ut_unit, FreeUnit>;

struct FreeConverter {
  void operator()(cv_converter* converter) const { cv_free(converter); }
};

using BasePowers = std::array<int, std::size(kBaseUnits)>;

// Callbacks of ut_accept_visitor(), which takes a unit apart; `powers` is a BasePowers.
ut_status visit_basic(const ut_unit* unit, void* powers) {
  const std::string_view symbol = ut_get_symbol(unit, UT_UTF8);
  for (std::size_t i = 0; i < std::size(kBaseUnits); ++i) {
    if (symbol == kBaseUnits[i].symbol) (*static_cast<BasePowers*>(powers))[i] += 1;
  }
  return UT_SUCCESS;
}

ut_status visit_product(const ut_unit* /*unit*/, int count, const ut_unit* const* basic,
                        const int* exponents, void* powers) {
  for (int k = 0; k < count; ++k) {
    BasePowers one{};
    visit_basic(basic[k], &one);
    for (std::size_t i = 0; i < one.size(); ++i)
      (*static_cast<BasePowers*>(powers))[i] += one[i] * exponents[k];
  }
  return UT_SUCCESS;
}

ut_status visit_scaled(const ut_unit* /*unit*/, double /*scale*/, const ut_unit* underlying,
                       double /*origin*/, void* powers);

ut_status visit_timestamp(const ut_unit* /*unit*/, const ut_unit* /*time*/, double /*origin*/,
                          void* /*powers*/) {
  return UT_VISIT_ERROR;
}

ut_status visit_logarithmic(const ut_unit* /*unit*/, double /*base*/, const ut_unit* /*reference*/,
                            void* /*powers*/) {
  return UT_VISIT_ERROR;
}

constexpr ut_visitor kBasePowers{visit_basic, visit_product, visit_scaled, visit_timestamp,
                                 visit_logarithmic};

ut_status visit_scaled(const ut_unit* /*unit*/, double /*scale*/, const ut_unit* underlying,
                       double /*origin*/, void* powers) {
  return ut_accept_visitor(underlying, &kBasePowers, powers);
}

// The unit system; lives as long as the process.
class UnitSystem {
 public:
  static UnitSystem& instance() {
    static UnitSystem system;
    return system;
  }

  UnitPointer parse(std::string_view text) const {
    return UnitPointer(ut_parse(system_, usual_spelling(text).c_str(), UT_UTF8));
  }

  // SI value of `unit` in terms of `target`. Through their quotient, because UDUNITS also converts
  // between a unit and its reciprocal: a period of 25 us would pass for 40 kHz.
  std::optional<double> ratio(const ut_unit* unit, const ut_unit* target) const {
    const UnitPointer quotient(ut_divide(unit, target));
    const UnitPointer one(ut_get_dimensionless_unit_one(system_));
    if (!quotient || !ut_are_convertible(quotient.get(), one.get())) return {};
    const std::unique_ptr<cv_converter, FreeConverter> converter(
        ut_get_converter(quotient.get(), one.get()));
    if (!converter) return {};
    return cv_convert_double(converter.get(), 1.0);
  }

 private:
  UnitSystem() : system_(ut_new_system()) {
    ut_set_error_message_handler(ut_ignore);
    for (const BaseUnit& base : kBaseUnits) add_base(base);
    for (const UnitPrefix& prefix : kPrefixes) {
      TWUM_ASSERT(ut_add_symbol_prefix(system_, prefix.symbol, prefix.value) == UT_SUCCESS);
    }
    for (const DerivedUnit& derived : kDerivedUnits) {
      const UnitPointer definition = parse(derived.definition);
      TWUM_ASSERT(definition != nullptr);
      const UnitPointer scaled(ut_scale(derived.factor, definition.get()));
      map(derived.symbol, scaled.get());
    }
    const UnitPointer one(ut_get_dimensionless_unit_one(system_));
    const UnitPointer percent(ut_scale(0.01, one.get()));
    map("%", percent.get());
    const UnitPointer ppm(ut_scale(1e-6, one.get()));
    map("ppm", ppm.get());
  }

  void add_base(const BaseUnit& base) {
    const UnitPointer unit(ut_new_base_unit(system_));
    map(base.symbol, unit.get());
    map(base.name, unit.get());
    TWUM_ASSERT(ut_map_unit_to_symbol(unit.get(), base.symbol, UT_UTF8) ==
                UT_SUCCESS);  // for base_powers()
    if (std::string_view(base.symbol) == "s") ut_set_second(unit.get());
  }

  static void map(const char* symbol, const ut_unit* unit) {
    TWUM_ASSERT(unit != nullptr && ut_map_symbol_to_unit(symbol, UT_UTF8, unit) == UT_SUCCESS);
  }

  ut_system* system_;
};

std::mutex& units_mutex() {
  static std::mutex mutex;
  return mutex;
}

bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || static_cast<unsigned char>(c) >= 0x80;
}

// A number in a unit may only be an exponent: after a letter, or after ^, **, + or -.
bool numbers_are_exponents(std::string_view unit) {
  for (std::size_t i = 0; i < unit.size(); ++i) {
    if (!is_digit(unit[i])) continue;
    std::size_t begin = i;
    while (i + 1 < unit.size() && is_digit(unit[i + 1])) ++i;
    if (i - begin > 1) return false;  // exponents have one digit
    if (begin > 0 && (unit[begin - 1] == '-' || unit[begin - 1] == '+')) --begin;
    if (begin == 0) return false;
    const char before = unit[begin - 1];
    const bool power = before == '^' || (before == '*' && begin > 1 && unit[begin - 2] == '*');
    if (!is_letter(before) && !power) return false;
  }
  return true;
}

// UDUNITS reads "W/m.K" as W.K/m, but most people mean W/(m.K).
bool product_after_slash(std::string_view unit) {
  bool slash = false;
  int depth = 0;
  for (const char c : unit) {
    if (c == '(') ++depth;
    if (c == ')') --depth;
    if (c == '/' && depth == 0) slash = true;
    if (slash && depth == 0 && (c == '.' || c == '*' || c == ' ')) return true;
  }
  return false;
}

// The denominator of a reciprocal such as "1/s"; any other unit as it is.
std::string_view without_one(std::string_view unit) {
  const bool reciprocal = unit.size() > 2 && unit.starts_with("1/") && is_letter(unit[2]);
  return reciprocal ? unit.substr(2) : unit;
}

}  // namespace

std::string unit_form_complaint(std::string_view typed) {
  constexpr std::size_t kLongestUnit = 60;
  const std::string unit = usual_spelling(typed);
  const std::string_view rest = without_one(unit);
  const bool starts_well =
      !rest.empty() && (is_letter(rest[0]) || rest[0] == '%' || rest[0] == '(');
  const bool control =
      std::ranges::any_of(unit, [](unsigned char c) { return c < 0x20 || c == 0x7F; });
  const bool shift =
      unit.find('@') != std::string_view::npos || unit.find(" from ") != std::string_view::npos;
  if (unit.size() > kLongestUnit || !starts_well || control || shift ||
      !numbers_are_exponents(rest)) {
    return "is not a unit";
  }
  if (product_after_slash(unit)) return "is ambiguous; put parentheses around the denominator";
  return {};
}

bool is_unit(std::string_view unit) {
  if (!unit_form_complaint(unit).empty()) return false;
  const std::lock_guard lock(units_mutex());
  return UnitSystem::instance().parse(unit) != nullptr;
}

std::optional<double> factor_to(std::string_view unit, std::string_view si_unit) {
  const std::lock_guard lock(units_mutex());
  const UnitSystem& system = UnitSystem::instance();
  const UnitPointer from = system.parse(unit);
  const UnitPointer to = system.parse(si_unit);
  TWUM_ASSERT(from != nullptr && to != nullptr);
  return system.ratio(from.get(), to.get());
}

BasePowers base_powers(std::string_view unit) {
  const std::lock_guard lock(units_mutex());
  const UnitPointer parsed = UnitSystem::instance().parse(unit);
  TWUM_ASSERT(parsed != nullptr);
  BasePowers powers{};
  TWUM_ASSERT(ut_accept_visitor(parsed.get(), &kBasePowers, &powers) == UT_SUCCESS);
  return powers;
}

}  // namespace twum::inline v0_1::io
