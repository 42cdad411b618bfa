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
#include <twum/io/diagnostics.hpp>
#include <twum/io/engineering.hpp>
#include <twum/io/units.hpp>
#include <twum/motion.hpp>
#include <twum/motors/expression.hpp>
#include <twum/motors/model_notes.hpp>
#include <twum/motors/motor_file.hpp>
#include <twum/motors/motor_limit.hpp>
#include <twum/motors/settings.hpp>
#include <twum/optim.hpp>
#include <twum/studies/motor_problem.hpp>
#include <twum/studies/run_study.hpp>
#include <twum/studies/sizing.hpp>
#include <twum/studies/study_file.hpp>
#include <twum/studies/study_result.hpp>
