// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/overconfidence.h"

#include <span>

namespace dewpoint::experiment {

/// Margin by which P(exists) may exceed one over the number of equal candidates before a method
/// counts as sure of a tie. A probability, within [0, 0.5): a judgment. It equals the calibration
/// error of P(exists) that the suite accepts in general, so scatter of the evidence is not counted
/// as a claim.
inline constexpr double kTieSlack = 0.05;

/// Whether a method claims knowledge that the images cannot give. `equalCandidates` objects (at
/// least 1) fit the target equally well, so an estimate is on the right one with a probability of
/// at most 1 / equalCandidates. P(exists) is the probability that the target exists and is at the
/// estimate. The result is true if the target is declared present and P(exists) exceeds that bound
/// by more than kTieSlack. It does not matter whether the estimate is right: that is luck.
bool isSureOfTie(const StatedBelief& belief, int equalCandidates);

/// Counts the frames in which a method is sure of a tie. The total is the number of all beliefs,
/// including those in which the method reports nothing.
Proportion sureOfTie(std::span<const StatedBelief> beliefs, int equalCandidates);

} // namespace dewpoint::experiment
