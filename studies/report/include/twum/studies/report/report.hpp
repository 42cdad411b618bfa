// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <twum/studies/store/result_store.hpp>
#include <twum/studies/study/study_file.hpp>

#include <string>

namespace twum::studies {

/// The page that shows a result: one HTML file that needs no other and no network. A function of its
/// arguments alone, for any number of threads.
/// @param study    the study that was run
/// @param text     the study as it was run, shown as it is
/// @param summary  content of summary.json
/// @param store    its evaluations; of more than 100,000 the page holds one of each so many, drawn at
///                 random but always the same, and says so
/// @throws InputError if `summary` is no such file
std::string report_html(const StudyFile& study, const std::string& text, const std::string& summary,
                        const ResultStore& store);

/// Builds report.html of a result directory from what else is in it.
/// @return the path of the page
/// @throws InputError if the directory holds no result; StoreError if the page cannot be written
std::string write_report(const std::string& directory);

}  // namespace twum::studies
