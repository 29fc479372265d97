// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/integration/kept_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace dewpoint::tests {
namespace {

constexpr std::int64_t kMostTicks = 3; ///< from set to set; after more the images were interrupted

} // namespace

KeptTrack keptTrack(const std::map<std::int64_t, SetRecord::Entry>& sets,
                    const Trajectory& trajectory,
                    const std::function<Eigen::Vector3d(std::int64_t)>& truth, int steadySets,
                    double errorBound) {
  std::map<std::int64_t, const TrajectorySample*> samples;
  for (const TrajectorySample& sample : trajectory.samples) {
    samples[sample.frame] = &sample;
  }
  KeptTrack kept;
  std::optional<std::int64_t> last;
  int steady = 0;
  for (const auto& [index, set] : sets) {
    if (set.images == 0) { // nothing came in a tenth of a second: no frame is tracked
      continue;
    }
    const bool follows = last && set.tick && *set.tick - *last <= kMostTicks;
    last = set.tick;
    steady = set.good < 2 ? 0 : follows ? steady + 1 : 1;
    const auto found = samples.find(index);
    if (steady < steadySets || found == samples.end()) {
      continue;
    }
    ++kept.due;
    const TrajectorySample& sample = *found->second;
    const double error = (sample.position - truth(*set.tick)).norm();
    if (sample.isValid) {
      kept.largestError = std::max(kept.largestError, error);
    }
    if (!sample.isValid || error > errorBound) {
      kept.lost.push_back(fmt::format(
          "frame {}, tick {}: {} good of {} images, {}, {:.0f} mm from the truth", index, *set.tick,
          set.good, set.images, sample.isValid ? "tracked" : "not tracked", 1000.0 * error));
    }
  }
  return kept;
}

} // namespace dewpoint::tests
