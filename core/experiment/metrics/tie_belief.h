// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/overconfidence.h"

#include <span>

namespace dewpoint::experiment {

/// In a tie, several objects (equal candidates) fit the target equally well. This is the margin by
/// which P(exists) may exceed 1 / (number of equal candidates) before a method counts as confident
/// in a tie. The margin is a probability, chosen by judgment from [0, 0.5). It equals the
/// calibration error of P(exists) that the suite accepts in general, so that random variation of
/// P(exists) does not count as confidence.
inline constexpr double kTieMargin = 0.05;

/// Returns whether a method is confident in a tie: whether it reports more certainty than the
/// images can provide. `equalCandidates` objects (at least 1) fit the target equally well, so the
/// probability that an estimate is on the right object is at most 1 / equalCandidates. P(exists) is
/// the probability that the target exists and is at the estimate. The result is true if the target
/// is declared present and P(exists) exceeds that bound by more than kTieMargin. Whether the
/// estimate is on the right object does not matter, because that is a matter of chance.
bool isConfidentInTie(const ReportedBelief& belief, int equalCandidates);

/// Counts the frames in which a method is confident in a tie. The total counts all beliefs,
/// including those in which the method reports nothing.
Proportion confidentInTie(std::span<const ReportedBelief> beliefs, int equalCandidates);

} // namespace dewpoint::experiment
