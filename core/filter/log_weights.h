// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::filter {

/// Returns the largest finite value of `count` log weights, or minus infinity if none is finite.
double largestLogWeight(const double* logWeights, std::int64_t count);

/// Sets weights[i] = exp(logWeights[i] - largest), or zero where the log weight is not finite, and
/// returns the sum of the weights, added in a fixed order. `largest` must be finite and at least as
/// large as every finite log weight.
double relativeWeights(const double* logWeights, std::int64_t count, double largest,
                       double* weights);

} // namespace dewpoint::filter
