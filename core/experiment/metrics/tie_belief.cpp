// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/tie_belief.h"

#include <algorithm>

namespace dewpoint::experiment {

bool isConfidentInTie(const ReportedBelief& belief, int equalCandidates) {
  return belief.declared && belief.probability > 1.0 / equalCandidates + kTieMargin;
}

Proportion confidentInTieShare(std::span<const ReportedBelief> beliefs, int equalCandidates) {
  const auto sure = std::ranges::count_if(beliefs, [&](const ReportedBelief& belief) {
    return isConfidentInTie(belief, equalCandidates);
  });
  return {sure, static_cast<std::int64_t>(beliefs.size())};
}

} // namespace dewpoint::experiment
