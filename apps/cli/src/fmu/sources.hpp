// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace twum::inline v0_1::cli {

/// Texts of the sources of C that every FMU carries.
/// @{
const char* plant_header();  ///< plant.h
const char* plant_source();  ///< plant.c
const char* fmi_source();    ///< fmi2.c
/// @}

}  // namespace twum::inline v0_1::cli
