// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <cstdint>

namespace dewpoint::filter {

/// The largest finite of `count` log weights; minus infinity if there is none.
double largestLogWeight(const double* logWeights, std::int64_t count);

/// weights[i] = exp(logWeights[i] - largest), zero where the log weight is not finite; `largest`
/// must be finite and no finite log weight above it. Returns their sum (see block_sums.h).
double relativeWeights(const double* logWeights, std::int64_t count, double largest,
                       double* weights);

} // namespace dewpoint::filter
