// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace twum::fuzz {

/// A motor file: what is accepted is written and read back the same, makes a motor, and has metrics
/// that are finite or say why not.
void feed_motor(std::string_view text);

/// A study file: what the reader accepts can be run, up to what only a file it names shows; resolved,
/// it is a study file again and the same study.
void feed_study(std::string_view text);

/// A table of designs, the first byte apart: the same records however the stream is cut, and results
/// that keep the columns in step.
void feed_table(std::string_view text);

/// Measured points: finite values, and weights of mean 1.
void feed_points(std::string_view text);

/// A quantity or unit: a finite number of one dimension.
void feed_units(std::string_view text);

/// A metric, a list of them, or a limit: what is accepted says itself again.
void feed_metrics(std::string_view text);

}  // namespace twum::fuzz
