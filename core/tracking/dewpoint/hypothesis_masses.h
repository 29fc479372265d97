// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <span>

namespace dewpoint::tracking {

/// Probability of the likeliest of some hypotheses, which compete with each other and with "not
/// there": exp(m) / (absence + the sum of exp(m) over all). `logMasses` are unnormalized log
/// probabilities, at least one; `absence` is linear. Of several that are equal the first counts as
/// the likeliest and the rest as its rivals.
double shareOfLargest(std::span<const double> logMasses, double absence);

} // namespace dewpoint::tracking
