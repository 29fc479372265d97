// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/setup/calibration/wand_views.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace dewpoint::setup {

/// Detections of the balls of a wand in the images of one camera.
struct CameraSightings {
  std::size_t detectionCount = 0; ///< number of balls found
  BoardCoverage imageCoverage;    ///< number of detections in each region of the image
};

/// Returns whether a camera saw the wand often enough and in a sufficient part of its image. With
/// fewer detections, a calibration may succeed, but with low accuracy.
bool hasEnoughDetections(const CameraSightings& camera);

/// Searches for the balls of a wand in frame sets from live cameras, in a separate thread. A frame
/// set that arrives while `kMaxWaitingFrameSets` others are waiting is dropped and counted as
/// dropped.
class WandCollector {
public:
  /// Largest number of waiting frame sets.
  static constexpr std::size_t kMaxWaitingFrameSets = 32;

  WandCollector(std::size_t cameraCount, const std::vector<ColorClassifier>& balls);
  /// Drops all frame sets that wait to be searched. Do not call this from the thread of a window,
  /// because it waits until the search in progress has ended.
  ~WandCollector();
  WandCollector(const WandCollector&) = delete;
  WandCollector& operator=(const WandCollector&) = delete;

  /// Adds a frame set to those that wait to be searched. Thread-safe; waits only for a lock, not
  /// for the search.
  void offer(const FrameSetPtr& frames);

  struct State {
    double durationSeconds = 0.0; ///< time from the first frame set to the newest one
    std::int64_t searchedFrameSetCount = 0;
    std::int64_t waitingFrameSetCount = 0; ///< number of frame sets that still wait to be searched
    std::int64_t droppedFrameSetCount = 0;
    std::vector<CameraSightings> cameras;
  };
  State state() const;
  /// Returns all detections of the balls so far, from which refineFromViews() calibrates.
  std::vector<std::vector<MarkerObservation>> views() const;

private:
  void run(const std::stop_token& stop);
  void search(const FrameSet& frames);

  mutable std::mutex queueMutex_;
  std::condition_variable_any wake_;
  std::deque<FrameSetPtr> queue_;
  std::int64_t taken_ = 0;
  std::int64_t dropped_ = 0;

  /// Guards the following members; the detectors do not hold it while working.
  mutable std::mutex seenMutex_;
  std::vector<std::vector<MarkerObservation>> views_;
  std::vector<CameraSightings> cameras_;
  std::int64_t searched_ = 0;
  std::optional<double> first_; ///< time of the first frame set, seconds
  double newest_ = 0.0;

  WandViews finder_;    ///< used only by the thread
  std::jthread thread_; ///< last member, since it uses the others
};

} // namespace dewpoint::setup
