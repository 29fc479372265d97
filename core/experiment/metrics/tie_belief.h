// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/metrics/overconfidence.h"

#include <span>

namespace dewpoint::experiment {

/// How far P(exists) may exceed one over the number of equal candidates before a method counts as
/// sure of a tie. A probability, within [0, 0.5): a judgment. It is the calibration error that the
/// suite accepts of P(exists) in general, so that scatter of the evidence is no claim.
inline constexpr double kTieSlack = 0.05;

/// Whether a method claims to know what nothing in the images tells. `equalCandidates` objects (at
/// least 1) are the target equally well, so that an estimate is on the right one with a probability
/// of at most 1 / equalCandidates; true if the target is declared present and P(exists), which is
/// the probability that the target exists and is where the estimate says, exceeds that by more than
/// kTieSlack. Being right is no excuse: it was luck.
bool isSureOfTie(const StatedBelief& belief, int equalCandidates);

/// The frames in which a method is sure of a tie. The total is the number of all beliefs, also of
/// those in which the method states nothing.
Proportion sureOfTie(std::span<const StatedBelief> beliefs, int equalCandidates);

} // namespace dewpoint::experiment
