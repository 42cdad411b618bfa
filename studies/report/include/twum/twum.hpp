// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// All of twum that a program is likely to want: motors and their metrics, design problems and their
/// solvers, files with units, studies and their results. twum/core.hpp and twum/optim.hpp have the
/// parts that stand alone; the tables, texts and schemas behind the files keep headers of their own.

/// @namespace twum::studies
/// Where motors meet optimization: files and units, metrics by name, design problems, studies.
///
/// What namespace twum says of units, threads and errors holds here.

#include <twum/core.hpp>
#include <twum/optim.hpp>
#include <twum/studies/diagnostics/diagnostics.hpp>
#include <twum/studies/metrics/expression.hpp>
#include <twum/studies/metrics/motor_limit.hpp>
#include <twum/studies/motor/model_notes.hpp>
#include <twum/studies/motor/motor_file.hpp>
#include <twum/studies/motor/settings.hpp>
#include <twum/studies/problem/motor_problem.hpp>
#include <twum/studies/problem/sizing.hpp>
#include <twum/studies/results/study_result.hpp>
#include <twum/studies/run/run_study.hpp>
#include <twum/studies/study/study_file.hpp>
#include <twum/studies/units/engineering.hpp>
#include <twum/studies/units/units.hpp>
