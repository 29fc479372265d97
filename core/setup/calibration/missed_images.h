// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/calibration/board_search.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace dewpoint::setup {

/// Collects the images in which a search did not find the board, and finds out why.
class MissedImages {
public:
  /// Creates an empty collection for `cameras` cameras. If `explained` is true, it keeps images so
  /// that explainMisses() can find the reasons, which takes time for each image.
  MissedImages(std::size_t cameras, bool explained) : images_(cameras), explained_(explained) {}

  /// Adds an image in which the board was not found to the missed images of `camera`, whose index
  /// is `index`. `file` is empty for a frame of a recording.
  void add(std::size_t index, std::string file, std::int64_t instant, const cv::Mat& image,
           BoardDetections::PerCamera& camera);
  /// Stores in `seen` why the board was not found, for the first images that each camera missed.
  /// Skips cameras whose images show another board. Error: Canceled.
  Status explainMisses(const BoardDetector& detector, const CalibrationProgress& progress,
                       BoardDetections& seen) const;

private:
  std::vector<std::vector<cv::Mat>> images_; ///< the first missed ones of each camera
  bool explained_ = false;
};

/// Consecutive missed images of a search that have the same reason.
struct MissedRun {
  std::string file; ///< name of an image file, which is always a separate run; empty for frames
  std::int64_t firstNumber = 0; ///< number of the first frame of the run
  std::int64_t lastNumber = 0;  ///< number of the last frame of the run
  int imageCount = 0;           ///< number of images in the run
  BoardMiss missReason;
};

/// Returns the images of a camera in which the board was not found, as runs. Consecutive frames are
/// combined into one run if no frame between them shows the board.
std::vector<MissedRun> missedRuns(const BoardDetections::PerCamera& camera);

/// Maximum number of runs that a sentence about missed images lists.
inline constexpr std::size_t kMaxListedRuns = 8;

/// Returns whether it is known for any image of a camera why the board was not found.
bool hasExplainedMiss(const BoardDetections::PerCamera& camera);

/// Returns a clause like "no board was found in left03.jpg (blurred, edges of 9 px), left07.jpg" or
/// "no board was found in frames 0-40, 60". Empty if the board was found in all images.
std::string missedImagesText(const BoardDetections::PerCamera& camera);

} // namespace dewpoint::setup
