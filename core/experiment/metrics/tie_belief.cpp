// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/metrics/tie_belief.h"

#include <algorithm>

namespace dewpoint::experiment {

bool isConfidentInTie(const ReportedBelief& belief, int equalCandidateCount) {
  return belief.isDeclared && belief.probability > 1.0 / equalCandidateCount + kTieMargin;
}

Proportion confidentInTieShare(std::span<const ReportedBelief> beliefs, int equalCandidateCount) {
  const auto sure = std::ranges::count_if(beliefs, [&](const ReportedBelief& belief) {
    return isConfidentInTie(belief, equalCandidateCount);
  });
  return {sure, static_cast<std::int64_t>(beliefs.size())};
}

} // namespace dewpoint::experiment
