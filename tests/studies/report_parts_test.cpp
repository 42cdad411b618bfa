// SPDX-License-Identifier: Apache-2.0
// The numbers inside a report page: curves, fields, slopes and rows, against closed forms.
#include "report/curves.hpp"
#include "report/encode.hpp"
#include "report/rows.hpp"
#include "report_numbers.hpp"
#include "search_support.hpp"
#include "support/constants.hpp"

#include <twum/core/motor.hpp>
#include <twum/motors/curve_points.hpp>
#include <twum/motors/motor_file.hpp>

#include <catch2/catch.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

using namespace twum;
using namespace twum::test;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

MotorDesign elastic_motor() {
  return read_motor_file(TWUM_SOURCE_DIR "/examples/motors/elastic-layer.yaml").design;
}

// The curve in a page of a motor with some of its parameters replaced.
Json curve_of(const MotorDesign& base, const std::vector<NamedValue>& values = {},
              bool whole = true) {
  std::optional<telling::MotorCurve> curve = telling::motor_curve("x", base, values, 161);
  REQUIRE(curve);
  curve->whole = whole;
  return curve_json(*curve);
}

std::vector<double> column(const Json& curve, const std::string& name) {
  for (const Json& one : curve["columns"])
    if (one["name"] == name) return numbers<double>(one["values"]);
  return {};
}

std::vector<StoredColumn> torque_columns() { return {{"preload", "N"}, {"stall_torque", "N.m"}}; }

}  // namespace

TEST_CASE("columns are encoded as RFC 4648 does", "[studies][report]") {
  // Section 10 there, the bytes of its examples of two, four and six letters as little-endian numbers.
  const auto encoded = [](const std::vector<std::uint16_t>& values) { return base64(values); };
  CHECK(encoded({}).empty());
  CHECK(encoded({0x6f66}) == "Zm8=");
  CHECK(encoded({0x6f66, 0x626f}) == "Zm9vYg==");
  CHECK(encoded({0x6f66, 0x626f, 0x7261}) == "Zm9vYmFy");
}

TEST_CASE("the module of a page is encoded as Ascii85 is, with other letters",
          "[studies][report]") {
  // "Man " is 9jqo^ there: the digits 24, 73, 80, 78, 61.
  const std::string letters =
      "()*+,-./0123456789:;=>?@ABCDEFGHIJKLMNOPQRSTUVWXYZ[]^_`abcdefghijklmnopqrstuvwxyz{|}~";
  REQUIRE(letters.size() == 85);
  const auto written = [&](std::initializer_list<std::size_t> digits) {
    std::string text;
    for (const std::size_t digit : digits) text += letters[digit];
    return text;
  };
  CHECK(base85("") == "");
  CHECK(base85("Man ") == written({24, 73, 80, 78, 61}));
  CHECK(base85(std::string(4, '\0')) == written({0, 0, 0, 0, 0}));
  CHECK(base85("\xff\xff\xff\xff") == written({82, 23, 54, 12, 0}));
  // A byte is two digits: 0x4d000000 = 24 * 85^4 + 63 * 85^3 + ...
  CHECK(base85("M") == written({24, 63}));
}

TEST_CASE("the curve of a report begins at the torque of the plateau (C8.5)", "[studies][report]") {
  const ElasticLayer exact{elastic_motor()};
  const Json curve = curve_of(exact.motor, {{"preload", "N", 120}, {"unknown", "1", 1}}, false);
  CHECK(curve["label"] == "x");
  CHECK(curve["design"]["preload"] == 120);
  CHECK(curve["design"]["amplitude"] == 1.6e-6);  // that of the base
  CHECK_FALSE(curve.contains("fields"));
  const auto torque = column(curve, "torque");
  REQUIRE(torque.size() == 161);
  // Products of a few factors, summed over zones.
  CHECK_THAT(torque[0], WithinRel(exact.plateau_torque(120), 1e-12));
  CHECK_THAT(curve["metrics"]["stall_torque"].get<double>(),
             WithinRel(exact.plateau_torque(120), 1e-12));
  // A little beyond no-load (C8.6), whose root is solved to about 1e-12.
  CHECK_THAT(curve["last_speed"].get<double>(),
             WithinRel(1.05 * exact.no_load(exact.angle_of_preload(120)), 1e-10));
  CHECK(torque.back() < 0);
}

TEST_CASE("the fields of a report add up to preload and torque", "[studies][report]") {
  const MotorDesign design = elastic_motor();
  const Json fields = curve_of(design)["fields"];
  CHECK(fields["kinetic"] == 0.2);
  CHECK(fields["static"] == 0.2);
  const auto phase = numbers<float>(fields["phase"]);
  const auto pressure = numbers<float>(fields["pressure"]);
  REQUIRE(phase.size() == pressure.size());
  const double step = (phase.back() - phase.front()) / static_cast<double>(phase.size() - 1);
  const double area = design.stator.contact_width * design.stator.contact_radius * step;
  // n waves of length 2 pi r / n: F_N = b r sum of p dphase. 100 places across the contact with kinks
  // at its ends: the trapezoid rule errs by some (1 / 100)^2, the ends by a place more or less of a
  // pressure of 1/50 of the largest; single precision by 1e-7.
  double force = 0;
  for (const float p : pressure) force += area * p;
  CHECK_THAT(force, WithinRel(160.0, 1e-3));
  const Motor motor(design);
  REQUIRE(fields["frames"].size() > 40);
  for (const Json& frame : {fields["frames"].front(), fields["frames"].back()}) {
    double torque = 0;
    for (const float t : numbers<float>(frame["traction"]))
      torque += area * t * design.stator.contact_radius;
    const double speed = frame["speed"].get<double>();
    CHECK_THAT(torque, WithinAbs(motor.operating_point(speed).torque, 2e-3));  // of 0.85 N.m
    for (const Json& zone : frame["zones"]) {
      CHECK(zone.size() == 3);
      CHECK(zone[1].get<double>() < zone[2].get<double>());
    }
  }
}

TEST_CASE("a motor out of contact has a curve without fields", "[studies][report]") {
  const Json curve = curve_of(elastic_motor(), {{"preload", "N", 0}});
  CHECK(curve["fields"].is_null());
  for (const double torque : column(curve, "torque")) CHECK(torque == 0);
}

TEST_CASE("only speeds with a periodic state have fields", "[studies][report]") {
  // Full contact, no damping, and a static friction above the kinetic one: near rest it never repeats.
  const std::vector<NamedValue> values{{"preload", "N", 20e3}, {"static_friction", "1", 0.4}};
  const Json fields = curve_of(elastic_motor(), values)["fields"];
  const MotorDesign pressed = with(elastic_motor(), Parameter::preload, 20e3);
  const Motor motor(with(pressed, Parameter::static_friction, 0.4));
  std::vector<double> answered;
  for (const double speed : curve_speeds(motor, 51)) {
    if (motor.operating_point(speed).status == PointStatus::ok) answered.push_back(speed);
  }
  CHECK(answered.size() < 51);
  std::vector<double> shown;
  for (const Json& frame : fields["frames"]) shown.push_back(frame["speed"].get<double>());
  CHECK(shown == answered);
}

TEST_CASE("values that make no motor have no curve", "[studies][report]") {
  CHECK_FALSE(telling::motor_curve("x", elastic_motor(), {{"preload", "N", -1}}, 11));
}

TEST_CASE("a value that is no number is left out of a design", "[studies][report]") {
  const Json curve = curve_of(elastic_motor(), {{"preload", "N", 150}, {"amplitude", "m", kNaN}});
  CHECK(curve["design"]["preload"] == 150);
  CHECK(curve["design"]["amplitude"] == elastic_motor().stator.amplitude);
}

TEST_CASE("rows of a report are those of the store", "[studies][report]") {
  ResultStore store(":memory:", torque_columns());
  store.add({0, 0, {100, 0.5}, "ok", {}});
  store.add({0, 1, {200, kNaN}, "a", {}});
  store.add({1, 0, {300, 1.5}, "ok", {}});
  const Json rows = rows_json(store);
  CHECK(rows["count"] == 3);
  CHECK(rows["total"] == 3);
  CHECK(rows["every"] == 1);
  CHECK(rows["densities"].is_null());
  CHECK(rows["offsets"] == "");
  CHECK(rows["columns"][1] == Json{{"name", "stall_torque"}, {"unit", "N.m"}});
  CHECK(numbers<double>(rows["values"][0]) == std::vector<double>{100, 200, 300});
  CHECK(std::isnan(numbers<double>(rows["values"][1])[1]));
  CHECK(rows["statuses"] == Json::array({"ok", "a"}));
  CHECK(numbers<std::uint16_t>(rows["status"]) == std::vector<std::uint16_t>{0, 1, 0});
}

TEST_CASE("of more rows than a page holds one of each few is kept, from its place",
          "[studies][report]") {
  // More than 100000: one of two, and a last group of one or two rows.
  const std::uint64_t total = GENERATE(100001U, 100002U, 100004U);
  ResultStore store(":memory:", {{"preload", "N"}});
  for (std::uint64_t i = 0; i < total; ++i) store.add({0, i, {static_cast<double>(i)}, "ok", {}});
  const Json rows = rows_json(store);
  CHECK(rows["total"] == total);
  CHECK(rows["every"] == 2);
  CHECK(rows["count"] == (total + 1) / 2);
  const auto values = numbers<double>(rows["values"][0]);
  const auto offsets = numbers<std::uint16_t>(rows["offsets"]);
  REQUIRE(values.size() == (total + 1) / 2);
  REQUIRE(offsets.size() == values.size());
  std::size_t wrong = 0;
  std::size_t second = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    wrong += values[i] == static_cast<double>(2 * i + offsets[i]) && offsets[i] < 2 ? 0 : 1;
    second += offsets[i];
  }
  CHECK(wrong == 0);
  if (total % 2 == 1) CHECK(offsets.back() == 0);  // there is no other row in it
  // Drawn by fair coins: 25000 of 50000, standard deviation sqrt(50000) / 2 = 112; five of them.
  CHECK_THAT(static_cast<double>(second), WithinAbs(25000, 560));
}

TEST_CASE("densities count every row once for each pair of its columns", "[studies][report]") {
  const double none = std::numeric_limits<double>::quiet_NaN();
  ResultStore store(":memory:", {{"preload", "N"},
                                 {"stall_torque", "N.m"},
                                 {"no_load_speed", "rad/s"},
                                 {"wavelengths", "1"}});
  // A hundred cells from 0 to 1000: one is 10 wide, and the last holds both its ends.
  store.add({0, 0, {0, 1, 5, 9}, "ok", {}});
  store.add({0, 1, {9.9, 1, 6, 9}, "ok", {}});
  store.add({0, 2, {995, 2, 7, 9}, "ok", {}});
  store.add({0, 3, {1000, 2, none, 9}, "a", {}});
  const Json told = densities_json(store);
  const auto cells = told["cells"].get<std::size_t>();
  REQUIRE(cells == 100);
  CHECK(told["ranges"][0] == Json::array({0.0, 1000.0}));
  const auto pair = numbers<std::uint32_t>(told["counts"]["0,1"]);
  REQUIRE(pair.size() == cells * cells);
  CHECK(pair[0] == 2);
  CHECK(pair[cells * cells - 1] == 2);
  const auto sum = [](const std::vector<std::uint32_t>& counts) {
    std::uint64_t total = 0;
    for (const std::uint32_t count : counts) total += count;
    return total;
  };
  CHECK(sum(pair) == 4);
  CHECK(sum(numbers<std::uint32_t>(told["counts"]["0,2"])) == 3);  // one has no speed
  CHECK_FALSE(told["counts"].contains("0,3"));                     // the same in all
}

TEST_CASE("small curves fall from the stall torque to nothing, and missing ones are nothing",
          "[studies][report]") {
  const ElasticLayer exact{elastic_motor()};
  ResultStore store(":memory:", {{"preload", "N"},
                                 {"kinetic_friction", "1"},
                                 {"static_friction", "1"},
                                 {"amplitude", "m"},
                                 {"stall_torque", "N.m"}});
  store.add({0, 0, {120, 0.2, 0.2, 1.6e-6, 1}, "ok", {}});
  store.add({0, 1, {-1, 0.2, 0.2, 1.6e-6, kNaN}, "not admissible", {}});
  store.add({0, 2, {0, 0.2, 0.2, 1.6e-6, 0}, "ok", {}});  // out of contact
  store.add({0, 3, {120, 0, 0, 1.6e-6, 0}, "ok", {}});    // without friction
  store.add({0, 4, {120, 0.2, 0.2, 0, 0}, "ok", {}});     // without a wave
  store.add({0, 5, {20e3, 0.2, 0.4, 1.6e-6, kNaN}, "no-periodic-state", {}});
  const Json curves = row_curves_json(store, exact.motor);
  CHECK(curves["every"] == 1);
  const auto points = curves["points"].get<std::size_t>();
  const auto speed = numbers<float>(curves["speed"]);
  const auto torque = numbers<float>(curves["torque"]);
  const auto shape = numbers<std::uint16_t>(curves["shape"]);
  REQUIRE(speed.size() == 6);
  REQUIRE(torque.size() == 6);
  REQUIRE(shape.size() == 6 * points);
  // Single precision: half of 2^-23, relative.
  CHECK_THAT(speed[0], WithinRel(exact.no_load(exact.angle_of_preload(120)), 1e-7));
  CHECK_THAT(torque[0], WithinRel(exact.plateau_torque(120), 1e-7));
  CHECK(shape[0] == 65535);
  CHECK(shape[points - 1] == 0);
  for (std::size_t i = 1; i < points; ++i) CHECK(shape[i] <= shape[i - 1]);
  for (std::size_t row = 1; row < 6; ++row) {
    CHECK(std::isnan(speed[row]));
    CHECK(std::isnan(torque[row]));
  }
  for (std::size_t i = points; i < shape.size(); ++i) CHECK(shape[i] == 0);
}

TEST_CASE("of many rows some have a small curve, and which is told", "[studies][report]") {
  // 20001 rows that need no work: no motor has such a preload.
  ResultStore store(":memory:", {{"preload", "N"}});
  for (std::uint64_t i = 0; i < 20001; ++i) store.add({0, i, {-1.0}, "not admissible", {}});
  const Json curves = row_curves_json(store, elastic_motor());
  CHECK(curves["every"] == 2);
  CHECK(numbers<float>(curves["speed"]).size() == 10001);
}
