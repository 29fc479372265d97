// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

namespace dewpoint::experiment {

/// Returns the probability that a chi-square variable is at most `value`: the regularized lower
/// incomplete gamma function P(degrees / 2, value / 2).
double chiSquareProbability(double value, double degrees);

/// Returns the value that a chi-square variable does not exceed with the given `probability`, which
/// is in [0, 1). This is the inverse of chiSquareProbability, with a relative error of about 1e-12.
double chiSquareQuantile(double probability, double degrees);

} // namespace dewpoint::experiment
