// SPDX-License-Identifier: Apache-2.0
#pragma once

/// Everything of twum::core: designs, operating points, curves, fields, metrics with derivatives.

#include <twum/base/error.hpp>
#include <twum/base/version.hpp>
#include <twum/core/contact/normal_contact.hpp>
#include <twum/core/contact/zone.hpp>
#include <twum/core/design/motor_design.hpp>
#include <twum/core/design/parameters.hpp>
#include <twum/core/performance/batch.hpp>
#include <twum/core/performance/metrics.hpp>
#include <twum/core/performance/motor.hpp>
