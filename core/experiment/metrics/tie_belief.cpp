// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/tie_belief.h"

#include <algorithm>

namespace dewpoint::experiment {

bool isSureOfTie(const StatedBelief& belief, int equalCandidates) {
  return belief.declared && belief.probability > 1.0 / equalCandidates + kTieSlack;
}

Proportion sureOfTie(std::span<const StatedBelief> beliefs, int equalCandidates) {
  const auto sure = std::ranges::count_if(
      beliefs, [&](const StatedBelief& belief) { return isSureOfTie(belief, equalCandidates); });
  return {sure, static_cast<std::int64_t>(beliefs.size())};
}

} // namespace dewpoint::experiment
