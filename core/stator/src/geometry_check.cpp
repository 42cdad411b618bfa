// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/stator/geometry.hpp>

#include "quantity_text.hpp"

#include <cmath>
#include <numbers>
#include <string>

namespace twum::inline v0_1::stator {
namespace {

const DimensionInfo& info(Dimension entry) {
  return dimension_table()[static_cast<std::size_t>(entry)];
}

// Collects all complaints, so that they are reported together.
class Complaints {
 public:
  explicit Complaints(const StatorGeometry& geometry) : geometry_(geometry) {}

  // A number has to lie on one side of a limit or of another entry; an absent number is valid. Comparisons are
  // written so that NaN is out of bounds.
  template <typename Limit>
  void above(Dimension entry, Limit limit) {
    bound(entry, "above", limit, [](double x, double y) { return x > y; });
  }
  template <typename Limit>
  void below(Dimension entry, Limit limit) {
    bound(entry, "below", limit, [](double x, double y) { return x < y; });
  }
  template <typename Limit>
  void at_least(Dimension entry, Limit limit) {
    bound(entry, "at least", limit, [](double x, double y) { return x >= y; });
  }
  template <typename Limit>
  void at_most(Dimension entry, Limit limit) {
    bound(entry, "at most", limit, [](double x, double y) { return x <= y; });
  }

  void add(std::string complaint) { found_.push_back(std::move(complaint)); }
  std::vector<std::string> found() && { return std::move(found_); }

 private:
  using Holds = bool (*)(double value, double limit);

  void bound(Dimension entry, const char* word, double limit, Holds holds) {
    bound(entry, word, limit, quantity_text(limit, info(entry).unit), holds);
  }
  void bound(Dimension entry, const char* word, Dimension other, Holds holds) {
    const double* limit = find(geometry_, other);
    if (limit == nullptr) return;
    bound(entry, word, *limit,
          quantity_text(*limit, info(other).unit) + " (" + std::string(info(other).name) + ")",
          holds);
  }
  void bound(Dimension entry, const char* word, double limit, const std::string& shown,
             Holds holds) {
    const double* value = find(geometry_, entry);
    if (value == nullptr || (holds(*value, limit) && std::isfinite(*value))) return;
    add(std::string(info(entry).name) + " must be " + word + " " + shown + ", but is " +
        quantity_text(*value, info(entry).unit));
  }

  const StatorGeometry& geometry_;
  std::vector<std::string> found_;
};

void check_ranges(Complaints& must) {
  using enum Dimension;
  for (const Dimension entry :
       {substrate_thickness, substrate_youngs_modulus, substrate_density, substrate_inner_radius,
        web_thickness, web_inner_radius, teeth_height, teeth_inner_radius, glue_youngs_modulus,
        glue_density, ceramic_thickness, ceramic_youngs_modulus, ceramic_density,
        ceramic_permittivity}) {
    must.above(entry, 0.0);
  }
  for (const Dimension entry : {teeth_slot_width, teeth_stiffness_share, glue_thickness}) {
    must.at_least(entry, 0.0);
  }
  must.at_most(teeth_stiffness_share, 1.0);
  for (const Dimension entry :
       {substrate_poisson_ratio, glue_poisson_ratio, ceramic_poisson_ratio}) {
    must.above(entry, -1.0);
    must.at_most(entry, 0.5);
  }
  must.below(substrate_inner_radius, substrate_outer_radius);
  must.below(web_inner_radius, web_outer_radius);
  must.below(teeth_inner_radius, teeth_outer_radius);
  must.below(ceramic_inner_radius, ceramic_outer_radius);
  must.below(electrodes_inner_radius, electrodes_outer_radius);
}

void check_teeth(Complaints& must, const Teeth& teeth) {
  if (teeth.count < 1) {
    must.add("teeth_count must be at least 1, but is " + std::to_string(teeth.count));
    return;
  }
  const double pitch = 2 * std::numbers::pi * teeth.inner_radius / teeth.count;
  if (!(teeth.slot_width < pitch)) {
    must.add("teeth_slot_width must be below the pitch of the teeth at their inner radius, " +
             quantity_text(pitch, "m") + ", but is " + quantity_text(teeth.slot_width, "m"));
  }
}

// Parts that lie on the metal, or on the ceramic, stay within it.
void check_places(Complaints& must, const StatorGeometry& g) {
  using enum Dimension;
  must.at_most(web_outer_radius, substrate_outer_radius);
  must.at_least(web_outer_radius, substrate_inner_radius);
  const bool web_inside = g.web && g.web->inner_radius < g.substrate.inner_radius;
  const Dimension inner = web_inside ? web_inner_radius : substrate_inner_radius;
  for (const Dimension entry : {teeth_inner_radius, ceramic_inner_radius})
    must.at_least(entry, inner);
  for (const Dimension entry : {teeth_outer_radius, ceramic_outer_radius})
    must.at_most(entry, substrate_outer_radius);
  must.at_least(electrodes_inner_radius, ceramic_inner_radius);
  must.at_most(electrodes_outer_radius, ceramic_outer_radius);
  // One edge given, the other the ceramic's.
  must.below(electrodes_inner_radius, ceramic_outer_radius);
  must.above(electrodes_outer_radius, ceramic_inner_radius);
}

// k_p^2 < 1: otherwise the blocked capacitance would be negative (P4.5).
void check_ceramic(Complaints& must, const Ceramic& c) {
  if (!std::isfinite(c.d31)) must.add("ceramic_d31 must be a finite number, but is not");
  const double coupling =
      2 * c.d31 * c.d31 * c.youngs_modulus / ((1 - c.poisson_ratio) * c.permittivity);
  if (coupling >= 1) {
    must.add(
        "ceramic_d31 must give a planar coupling factor squared, 2 d31^2 E / ((1 - nu) "
        "permittivity), below 1 (check ceramic_permittivity, at constant stress, too), but it is " +
        quantity_text(coupling, "1"));
  }
}

}  // namespace

std::vector<std::string> geometry_complaints(const StatorGeometry& geometry) {
  Complaints must(geometry);
  check_ranges(must);
  check_places(must, geometry);
  if (geometry.teeth) check_teeth(must, *geometry.teeth);
  check_ceramic(must, geometry.ceramic);
  const double waves = geometry.electrodes.waves_per_phase;
  if (!(waves > 0))
    must.add("electrodes_waves_per_phase must be above 0, but is " + quantity_text(waves, "1"));
  return std::move(must).found();
}

void check_geometry(const StatorGeometry& geometry) {
  std::string text;
  for (const std::string& complaint : geometry_complaints(geometry))
    text += (text.empty() ? "" : "; ") + complaint;
  if (!text.empty()) throw InputError(text);
}

}  // namespace twum::inline v0_1::stator
