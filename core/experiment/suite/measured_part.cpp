// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/measured_part.h"

#include <algorithm>

namespace dewpoint::experiment {

bool isMeasured(const ScenarioRun& run, std::int64_t frame) {
  return run.measuredFrames.empty() || std::ranges::binary_search(run.measuredFrames, frame);
}

ScenarioRun measuredPart(const ScenarioRun& run) {
  ScenarioRun part = run;
  if (run.measuredFrames.empty()) {
    return part;
  }
  part.measuredFrames.clear();
  part.marks.clear();
  part.events.clear();
  part.frames = nullptr;
  part.frameCount = static_cast<std::int64_t>(run.measuredFrames.size());
  part.framesPerSecond *=
      static_cast<double>(part.frameCount) / static_cast<double>(run.frameCount);
  part.truth.samples.clear();
  for (TrajectorySample sample : run.truth.samples) {
    const auto found = std::ranges::lower_bound(run.measuredFrames, sample.frame);
    if (found != run.measuredFrames.end() && *found == sample.frame) {
      sample.frame = found - run.measuredFrames.begin();
      part.truth.samples.push_back(sample);
    }
  }
  return part;
}

} // namespace dewpoint::experiment
