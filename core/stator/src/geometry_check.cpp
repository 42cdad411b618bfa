// SPDX-License-Identifier: Apache-2.0
#include <twum/base/error.hpp>
#include <twum/stator/geometry.hpp>

#include <cmath>
#include <numbers>
#include <sstream>
#include <string>

namespace twum::stator {
namespace {

// Collects what is wrong, so that one look is enough.
class Complaints {
 public:
  explicit Complaints(const StatorGeometry& geometry) : geometry_(geometry) {}

  // A number has to lie within bounds; an absent one is in order.
  void above(Dimension entry, double limit) { bound(entry, "above", limit); }
  void below(Dimension entry, double limit) { bound(entry, "below", limit); }
  void at_least(Dimension entry, double limit) { bound(entry, "at least", limit); }
  void at_most(Dimension entry, double limit) { bound(entry, "at most", limit); }

  // inner < outer
  void ordered(Dimension inner, Dimension outer) {
    const double* low = find(geometry_, inner);
    const double* high = find(geometry_, outer);
    if (low && high && !(*low < *high)) {
      add(name(inner) + " is " + text(*low) + " m; it must be below " + name(outer) + " = " +
          text(*high) + " m");
    }
  }

  void add(const std::string& complaint) { text_ += (text_.empty() ? "" : "; ") + complaint; }

  void finish() const {
    if (!text_.empty()) throw InputError("stator geometry: " + text_);
  }

  static std::string text(double value) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << value;
    return stream.str();
  }

 private:
  static std::string name(Dimension entry) {
    return std::string(dimension_table()[static_cast<std::size_t>(entry)].name);
  }

  void bound(Dimension entry, const std::string& word, double limit) {
    const double* value = find(geometry_, entry);
    if (!value) return;
    // Written so that NaN is out of bounds.
    const bool holds = word == "above"      ? *value > limit
                       : word == "below"    ? *value < limit
                       : word == "at least" ? *value >= limit
                                            : *value <= limit;
    if (holds && std::isfinite(*value)) return;
    std::string unit(dimension_table()[static_cast<std::size_t>(entry)].unit);
    unit = unit == "1" ? "" : " " + unit;
    add(name(entry) + " is " + text(*value) + unit + "; it must be " + word + " " + text(limit) +
        unit);
  }

  const StatorGeometry& geometry_;
  std::string text_;
};

void check_ranges(Complaints& must) {
  using enum Dimension;
  for (const Dimension entry :
       {substrate_thickness, substrate_youngs_modulus, substrate_density, substrate_inner_radius,
        web_thickness, web_inner_radius, teeth_height, teeth_inner_radius, glue_youngs_modulus,
        glue_density, ceramic_thickness, ceramic_youngs_modulus, ceramic_density,
        ceramic_permittivity}) {
    must.above(entry, 0);
  }
  for (const Dimension entry : {teeth_slot_width, teeth_stiffness_share, glue_thickness}) {
    must.at_least(entry, 0);
  }
  must.at_most(teeth_stiffness_share, 1);
  for (const Dimension entry :
       {substrate_poisson_ratio, glue_poisson_ratio, ceramic_poisson_ratio}) {
    must.above(entry, -1);
    must.at_most(entry, 0.5);
  }
  must.ordered(substrate_inner_radius, substrate_outer_radius);
  must.ordered(web_inner_radius, web_outer_radius);
  must.ordered(teeth_inner_radius, teeth_outer_radius);
  must.ordered(ceramic_inner_radius, ceramic_outer_radius);
  must.ordered(electrodes_inner_radius, electrodes_outer_radius);
}

void check_teeth(Complaints& must, const Teeth& teeth) {
  if (teeth.count < 1) {
    must.add("teeth_count is " + std::to_string(teeth.count) + "; it must be at least 1");
    return;
  }
  const double pitch = 2 * std::numbers::pi * teeth.inner_radius / teeth.count;
  if (!(teeth.slot_width < pitch)) {
    must.add("teeth_slot_width is " + Complaints::text(teeth.slot_width) +
             " m; it must be below the pitch of the teeth at their inner radius, " +
             Complaints::text(pitch) + " m");
  }
}

// Parts that lie on the metal, or on the ceramic, stay within it.
void check_places(Complaints& must, const StatorGeometry& g) {
  using enum Dimension;
  double inner = g.substrate.inner_radius;
  if (g.web) {
    must.at_most(web_outer_radius, g.substrate.outer_radius);
    must.at_least(web_outer_radius, g.substrate.inner_radius);
    inner = std::fmin(inner, g.web->inner_radius);
  }
  for (const Dimension entry : {teeth_inner_radius, ceramic_inner_radius})
    must.at_least(entry, inner);
  for (const Dimension entry : {teeth_outer_radius, ceramic_outer_radius}) {
    must.at_most(entry, g.substrate.outer_radius);
  }
  must.at_least(electrodes_inner_radius, g.ceramic.inner_radius);
  must.at_most(electrodes_outer_radius, g.ceramic.outer_radius);
  // One edge given, the other the ceramic's.
  if (g.electrodes.inner_radius) must.below(electrodes_inner_radius, g.ceramic.outer_radius);
  if (g.electrodes.outer_radius) must.above(electrodes_outer_radius, g.ceramic.inner_radius);
}

// k_p^2 < 1: otherwise the blocked capacitance would be negative (P4.5).
void check_ceramic(Complaints& must, const Ceramic& c) {
  if (!std::isfinite(c.d31)) must.add("ceramic_d31 is not a finite number");
  const double coupling =
      2 * c.d31 * c.d31 * c.youngs_modulus / ((1 - c.poisson_ratio) * c.permittivity);
  if (coupling >= 1) {
    must.add(
        "the ceramic's planar coupling factor squared, 2 d31^2 E / ((1 - nu) permittivity), is " +
        Complaints::text(coupling) +
        "; it must be below 1: check ceramic_d31 and ceramic_permittivity (at constant stress)");
  }
}

}  // namespace

void check_geometry(const StatorGeometry& geometry) {
  Complaints must(geometry);
  check_ranges(must);
  check_places(must, geometry);
  if (geometry.teeth) check_teeth(must, *geometry.teeth);
  check_ceramic(must, geometry.ceramic);
  if (!(geometry.electrodes.waves_per_phase > 0)) {
    must.add("electrodes_waves_per_phase is " +
             Complaints::text(geometry.electrodes.waves_per_phase) + "; it must be above 0");
  }
  must.finish();
}

}  // namespace twum::stator
