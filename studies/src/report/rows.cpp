// SPDX-License-Identifier: Apache-2.0
#include "report/rows.hpp"

#include "report/encode.hpp"

#include <twum/base/error.hpp>
#include <twum/base/ordered.hpp>
#include <twum/core/metrics.hpp>
#include <twum/core/motor.hpp>
#include <twum/core/parameters.hpp>
#include <twum/optim/random.hpp>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <optional>
#include <vector>

namespace twum::inline v0_1::studies {
namespace {

// Limit of rows in a page. The page says that it shows a sample; results.csv has all rows.
constexpr std::uint64_t kMostRows = 100000;
// 20000 curves of 24 points are 1 MB in the page and half a second of work.
constexpr std::uint64_t kMostCurves = 20000;
constexpr std::size_t kPoints = 24;
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

struct SmallCurve {
  std::vector<ParameterValue> design;
  float speed{kNone};   // [rad/s]
  float torque{kNone};  // [N m]
  std::vector<std::uint16_t> shape = std::vector<std::uint16_t>(kPoints, 0);
};

void draw(const MotorDesign& base, SmallCurve& curve) {
  std::optional<Motor> motor;
  try {
    motor.emplace(with(base, curve.design));
  } catch (const InputError&) {
    return;  // not admissible, as the row's status says
  }
  const MetricValue no_load =
      evaluate(*motor, MetricRequest{Metric::no_load_speed, Argument::none, 0});
  if (no_load.status != MetricStatus::ok || !(no_load.value > 0)) return;
  std::vector<double> torques;
  for (std::size_t i = 0; i < kPoints; ++i) {
    const double speed = no_load.value * static_cast<double>(i) / static_cast<double>(kPoints - 1);
    const double torque = motor->operating_point(speed).torque;
    torques.push_back(std::isfinite(torque) ? std::max(torque, 0.0) : 0.0);
  }
  const double most = *std::max_element(torques.begin(), torques.end());
  if (!(most > 0)) return;
  curve.speed = static_cast<float>(no_load.value);
  curve.torque = static_cast<float>(most);
  for (std::size_t i = 0; i < kPoints; ++i)
    curve.shape[i] = static_cast<std::uint16_t>(std::lround(65535 * torques[i] / most));
}

// The k such that every k-th of `count` items gives at most `most`.
std::uint64_t thinning(std::uint64_t count, std::uint64_t most) {
  return std::max<std::uint64_t>(1, (count + most - 1) / most);
}

// Rows of the store that the page holds: one of each `every`. Which one is drawn at random, since
// every k-th of a Sobol sequence or of a grid lies in a part of the space only.
class Sample {
 public:
  explicit Sample(const ResultStore& store)
      : store_(store), total_(store.rows()), every_(thinning(total_, kMostRows)) {}

  std::uint64_t total() const { return total_; }
  std::uint64_t every() const { return every_; }
  std::uint64_t count() const { return (total_ + every_ - 1) / every_; }

  // Place of the i-th in its group; it fits into two bytes.
  std::uint64_t offset(std::uint64_t i) const {
    const std::uint64_t group = std::min(every_, total_ - i * every_);
    return optim::Random(0, 0, i).below(std::min<std::uint64_t>(group, 65536));
  }

  // Calls back with each row and its number in the page.
  void read(const std::function<void(const StoredRow&, std::uint64_t)>& visit) const {
    std::uint64_t number = 0;
    std::uint64_t i = 0;
    store_.read([&](const StoredRow& row) {
      if (number++ != i * every_ + (i < count() ? offset(i) : 0)) return;
      visit(row, i++);
    });
  }

 private:
  const ResultStore& store_;
  std::uint64_t total_;
  std::uint64_t every_;
};

}  // namespace

Json rows_json(const ResultStore& store) {
  const std::vector<StoredColumn>& columns = store.columns();
  std::vector<std::vector<double>> values(columns.size());
  std::vector<std::uint16_t> status;
  std::map<std::string, std::uint16_t> numbers;
  std::vector<std::string> words;
  std::vector<std::uint16_t> offsets;
  const Sample sample(store);
  sample.read([&](const StoredRow& row, std::uint64_t number) {
    offsets.push_back(static_cast<std::uint16_t>(sample.offset(number)));
    for (std::size_t i = 0; i < columns.size(); ++i) values[i].push_back(row.values[i]);
    const auto [found, fresh] =
        numbers.try_emplace(row.status, static_cast<std::uint16_t>(words.size()));
    if (fresh) words.push_back(row.status);
    status.push_back(found->second);
  });
  Json json{{"count", status.size()},
            {"every", sample.every()},
            {"offsets", sample.every() > 1 ? base64(offsets) : ""},
            {"total", sample.total()},
            {"columns", Json::array()},
            {"values", Json::array()},
            {"statuses", words},
            {"status", base64(status)},
            {"densities", sample.every() > 1 ? densities_json(store) : Json(nullptr)}};
  for (std::size_t i = 0; i < columns.size(); ++i) {
    json["columns"].push_back({{"name", columns[i].name}, {"unit", columns[i].unit}});
    json["values"].push_back(base64(values[i]));
  }
  return json;
}

Json row_curves_json(const ResultStore& store, const MotorDesign& base) {
  std::vector<std::pair<std::size_t, Parameter>> variables;
  for (std::size_t i = 0; i < store.columns().size(); ++i) {
    if (const auto parameter = find_parameter(store.columns()[i].name))
      variables.emplace_back(i, *parameter);
  }
  const Sample sample(store);
  const std::uint64_t every = thinning(sample.count(), kMostCurves);
  std::vector<SmallCurve> curves;
  sample.read([&](const StoredRow& stored, std::uint64_t number) {
    if (number % every != 0) return;
    SmallCurve curve;
    for (const auto& [column, parameter] : variables)
      curve.design.emplace_back(parameter, stored.values[column]);
    curves.push_back(std::move(curve));
  });
  std::size_t next = 0;
  run_ordered<std::size_t>(
      job_count(0), [&](std::size_t& i) { return (i = next++) < curves.size(); },
      [&](std::size_t& i) { draw(base, curves[i]); }, [](std::size_t&) {});
  std::vector<float> speeds;
  std::vector<float> torques;
  std::vector<std::uint16_t> shapes;
  for (const SmallCurve& curve : curves) {
    speeds.push_back(curve.speed);
    torques.push_back(curve.torque);
    shapes.insert(shapes.end(), curve.shape.begin(), curve.shape.end());
  }
  return {{"every", every},
          {"points", kPoints},
          {"speed", base64(speeds)},
          {"torque", base64(torques)},
          {"shape", base64(shapes)}};
}

}  // namespace twum::inline v0_1::studies
