// SPDX-License-Identifier: Apache-2.0
#include "plot/curve_plot.hpp"

#include "plot/style.hpp"
#include "plot/told_panel.hpp"

#include <cmath>

namespace twum::inline v0_1::cli {

Picture curve_picture(const studies::MotorFile& file, double first, double last) {
  // Half a pixel of the PNG is 1 / 2400 of the width; the curve has few bends, and 600 points are smooth.
  constexpr int kPoints = 601;
  telling::MotorCurve curve{"", Motor(file.design)};
  for (int i = 0; i < kPoints; ++i)
    curve.points.push_back(curve.motor.operating_point(
        std::lerp(first, last, static_cast<double>(i) / (kPoints - 1))));
  return picture_of("curve", told_chart(motor_title(file), telling::curve_charts({&curve, 1})));
}

}  // namespace twum::inline v0_1::cli
