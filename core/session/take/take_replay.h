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

/// Comparison of the live trajectory of a take with the trajectory obtained by tracking its
/// recorded images again, with the same seed and settings.
struct ReplayComparison {
  std::int64_t liveFrameCount = 0; ///< number of frames of the live run that are in the take
  /// Number of live frames before the first one whose images are in the take. If it is not 0,
  /// nothing is compared, because tracking depends on all frames since the start of the run.
  std::int64_t frameCountBeforeTake = 0;
  std::int64_t comparedFrameCount = 0; ///< frames that were tracked again and compared
  /// Compared frames in which the estimate of at least one target differs.
  std::int64_t differingFrameCount = 0;
  std::optional<std::int64_t> firstDifferingFrame; ///< number of the first differing frame
  double largestPositionDifference =
      0.0; ///< largest distance between the two positions of a target, meters
  std::int64_t incompleteFrameCount = 0; ///< frames that lack an image in the take
  std::optional<std::int64_t> firstIncompleteFrame;
  std::vector<ResultRange>
      framesWithOtherSettings; ///< frames whose live results came from earlier settings
  /// True if iterations had a time budget, so that results depend on the computer's speed.
  bool hasTimeBudget = false;
  /// Names of cameras that send uncompressed images, which are stored with slightly other colors.
  std::vector<std::string> changedCameras;

  /// Returns whether all frames were compared and their results are bit-identical.
  bool isBitIdentical() const {
    return comparedFrameCount > 0 && comparedFrameCount == liveFrameCount &&
           differingFrameCount == 0 && frameCountBeforeTake == 0;
  }
};

/// Returns whether the folder of a take contains the results of a live run.
bool hasLiveRun(const std::filesystem::path& take);

/// Function that receives the number of finished frames and their total. If it returns false, the
/// comparison is canceled.
using ReplayProgress = std::function<bool(std::int64_t, std::int64_t)>;

/// Tracks the images of a take again, grouped into the same frames as in the live run, and compares
/// the results with the live trajectory. `take` is the folder of the take, and `threads` the number
/// of filter threads. Returns NotFound if there are no live results, Canceled if `progress`
/// returned false, and the errors of reading the files.
Result<ReplayComparison> compareReplay(const std::filesystem::path& take, int threads,
                                       const ReplayProgress& progress);

/// Returns English sentences that describe the result of the comparison, the most important one
/// first.
std::vector<std::string> describeReplay(const ReplayComparison& comparison);

} // namespace dewpoint::session
