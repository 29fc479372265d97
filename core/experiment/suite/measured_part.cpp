// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/suite/measured_part.h"

#include <algorithm>

namespace dewpoint::experiment {

bool isMeasured(const ScenarioRun& run, std::int64_t frame) {
  return run.measuredFrames.empty() || std::ranges::binary_search(run.measuredFrames, frame);
}

bool measuresSuccessiveFrames(const ScenarioRun& run) {
  return std::ranges::adjacent_find(run.measuredFrames, [](std::int64_t one, std::int64_t next) {
           return next != one + 1;
         }) == run.measuredFrames.end();
}

ScenarioRun measuredPart(const ScenarioRun& run) {
  ScenarioRun part = run;
  if (run.measuredFrames.empty()) {
    return part;
  }
  part.measuredFrames.clear();
  part.markedCenters.clear();
  part.events.clear();
  part.frames = nullptr;
  part.frameCount = static_cast<std::int64_t>(run.measuredFrames.size());
  part.framesPerSecond *=
      static_cast<double>(part.frameCount) / static_cast<double>(run.frameCount);
  part.truth.samples.clear();
  part.extents.clear();
  const bool sized = run.extents.size() == run.truth.samples.size();
  for (std::size_t k = 0; k < run.truth.samples.size(); ++k) {
    TrajectorySample sample = run.truth.samples[k];
    const auto found = std::ranges::lower_bound(run.measuredFrames, sample.frame);
    if (found != run.measuredFrames.end() && *found == sample.frame) {
      sample.frame = found - run.measuredFrames.begin();
      part.truth.samples.push_back(sample);
      if (sized) {
        part.extents.push_back(run.extents[k]);
      }
    }
  }
  return part;
}

} // namespace dewpoint::experiment
