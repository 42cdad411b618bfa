// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "kinds/calibrate/measured_fit.hpp"

#include <twum/studies/study.hpp>
#include <twum/studies/study_file.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace twum::inline v0_1::studies {

/// The fit that a calibration asks for.
struct AskedFit {
  MeasuredFit fit;
  std::vector<std::string> notes;  ///< notes on its points
  /// Index of the column of each point if each column has a scatter of its own; else empty.
  std::vector<std::size_t> columns;
};

/// Names of tables without folders: a result directory has other paths to the same ones.
std::vector<std::string> file_names(const std::vector<std::string>& paths);

/// Each variable of the study once, or once for each table where these have values of their own.
std::vector<FitParameter> fit_parameters(const CalibrateStudy& asked);

/// Reads the tables of a calibration.
/// @throws InputError, or FileError with the places in a table, if they do not make a fit
AskedFit asked_fit(const CalibrateStudy& asked, const StudyFile& file);

}  // namespace twum::inline v0_1::studies
