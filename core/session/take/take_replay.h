// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/session/run/result_settings.h"

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace dewpoint::session {

/// How the live trajectory of a take compares with that of its recorded images, tracked again with
/// the same seed and settings.
struct ReplayComparison {
  std::int64_t frames = 0; ///< live frames in the take
  /// Live frames before the first one whose images are in the take. If there are any, nothing is
  /// compared: tracking depends on all frames since the start of the run.
  std::int64_t framesBefore = 0;
  std::int64_t compared = 0;  ///< frames that were tracked again and compared
  std::int64_t differing = 0; ///< of them, frames with another estimate of any target
  std::optional<std::int64_t> firstDifference; ///< number of the first differing frame
  double largestDistance = 0.0;                ///< between the two positions of a target, meters
  std::int64_t incomplete = 0;                 ///< frames of which an image is not in the take
  std::optional<std::int64_t> firstIncomplete;
  std::vector<ResultRange> otherSettings;  ///< frames that were tracked with earlier settings
  bool hasTimeBudget = false;              ///< results depend on the speed of the computer
  std::vector<std::string> changedCameras; ///< cameras whose images are stored with other pixels

  /// Returns whether all frames were compared and are the same, to the last bit.
  bool isSame() const {
    return compared > 0 && compared == frames && differing == 0 && framesBefore == 0;
  }
};

/// Returns whether a take has the results of a live run.
bool hasLiveRun(const std::filesystem::path& take);

/// Receives the number of frames done and their total; returning false cancels.
using ReplayProgress = std::function<bool(std::int64_t, std::int64_t)>;

/// Tracks the images of a take again, in the frames of the live run, and compares the results with
/// the live trajectory. `take`: the folder of the take. Errors: those of reading its files,
/// NotFound if it has no live results, and Canceled.
Result<ReplayComparison> compareReplay(const std::filesystem::path& take, int threads,
                                       const ReplayProgress& progress);

/// Returns the sentences, in English, that tell the result, the most important one first.
std::vector<std::string> describeReplay(const ReplayComparison& comparison);

} // namespace dewpoint::session
