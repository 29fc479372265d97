// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/calibration/board/board_coverage.h"
#include "core/setup/wand_views.h"

#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>
#include <vector>

namespace dewpoint::setup {

/// What a camera saw of a wand.
struct CameraSightings {
  std::size_t count = 0;  ///< balls found
  BoardCoverage coverage; ///< in which regions of the image, how often
};

/// Whether a camera saw the target often and in enough of its image: a calibration from less may
/// succeed, but its accuracy will be low.
bool sawEnough(const CameraSightings& camera);

/// Looks for the balls of a wand in frame sets as they come from live cameras, in a thread of its
/// own: offering costs a lock, never more. A frame set that comes while `kWaiting` others wait is
/// dropped, and counted.
class WandCollector {
public:
  /// Frame sets that wait at most.
  static constexpr std::size_t kWaiting = 32;

  WandCollector(std::size_t cameraCount, const std::vector<ColorClassifier>& balls);
  ~WandCollector(); ///< drops waiting sets and waits for the one in work: not in a window's
                    ///< thread
  WandCollector(const WandCollector&) = delete;
  WandCollector& operator=(const WandCollector&) = delete;

  /// From any thread; returns at once.
  void offer(const FrameSetPtr& frames);

  struct State {
    double seconds = 0.0; ///< from the first frame set's time to the newest one's
    std::int64_t searched = 0;
    std::int64_t waiting = 0; ///< taken, but not yet searched
    std::int64_t dropped = 0;
    std::vector<CameraSightings> cameras;
  };
  State state() const;
  /// All sightings so far: for refineFromViews().
  std::vector<std::vector<MarkerObservation>> views() const;

private:
  void run(const std::stop_token& stop);
  void search(const FrameSet& frames);

  mutable std::mutex queueMutex_;
  std::condition_variable_any wake_;
  std::deque<FrameSetPtr> queue_;
  std::int64_t taken_ = 0;
  std::int64_t dropped_ = 0;

  mutable std::mutex seenMutex_; ///< guards what follows; the finders work without it
  std::vector<std::vector<MarkerObservation>> views_;
  std::vector<CameraSightings> cameras_;
  std::int64_t searched_ = 0;
  std::optional<double> first_; ///< seconds
  double newest_ = 0.0;

  WandViews finder_;    ///< the thread's own
  std::jthread thread_; ///< last: it uses the rest
};

} // namespace dewpoint::setup
