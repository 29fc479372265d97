// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/overconfidence.h"

#include <span>

namespace dewpoint::experiment {

/// Margin by which P(exists) may exceed 1 / (number of equal candidates) before a method counts as
/// confident in a tie. In a tie, several objects (equal candidates) fit the target equally well.
/// The margin equals the calibration error of P(exists) that the suite accepts in general, so that
/// random variation of P(exists) does not count as confidence.
inline constexpr double kTieMargin = 0.05;

/// Returns whether a method is more confident than the images allow, in a tie:
/// `equalCandidateCount` objects (at least 1) fit the target equally well. The estimate is then on
/// the right object with a probability of at most 1 / equalCandidateCount. Returns true if the
/// target is declared present and the reported P(exists) exceeds this bound by more than
/// kTieMargin. Whether the estimate is on the right object does not matter, because this is a
/// matter of chance.
bool isConfidentInTie(const ReportedBelief& belief, int equalCandidateCount);

/// Counts the frames in which a method is confident in a tie (isConfidentInTie()), out of all
/// beliefs, including those in which the method reports nothing.
Proportion confidentInTieShare(std::span<const ReportedBelief> beliefs, int equalCandidateCount);

} // namespace dewpoint::experiment
