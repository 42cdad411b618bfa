// SPDX-License-Identifier: Apache-2.0
#pragma once

/// @file
/// The headers that most programs need: motors and their metrics, design problems and their solvers, files with
///         units, studies and their results. twum/core.hpp and twum/optim.hpp hold the parts that can be used on
///         their own. Tables, texts and schemas behind the files have headers of their own.

/// @namespace twum::studies Motors and optimization together: files and units, metrics by name, design problems,
///         studies.
///
/// The rules of namespace twum on units, threads and errors hold here.

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
