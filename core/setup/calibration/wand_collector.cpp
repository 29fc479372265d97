// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/calibration/wand_collector.h"

#include "core/base/thread_priority.h"

#include <algorithm>

namespace dewpoint::setup {
namespace {

// Tuned; where no source is named here or in the docs, the origin is not recorded.
/// Instants in which a camera saw the wand.
constexpr std::size_t kEnoughSightings = 150;
/// Part of the regions of its image in which it was seen.
constexpr double kEnoughImage = 0.5;

} // namespace

bool hasEnoughDetections(const CameraSightings& camera) {
  return camera.detectionCount >= kEnoughSightings &&
         camera.imageCoverage.coveredFraction() >= kEnoughImage;
}

WandCollector::WandCollector(std::size_t cameraCount, const std::vector<ColorClassifier>& balls)
    : views_(cameraCount), cameras_(cameraCount), finder_(cameraCount, balls),
      thread_([this](const std::stop_token& stop) { run(stop); }) {}

WandCollector::~WandCollector() = default;

void WandCollector::offer(const FrameSetPtr& frames) {
  {
    const std::lock_guard lock(queueMutex_);
    if (queue_.size() >= kMaxWaitingFrameSets) {
      ++dropped_;
      return;
    }
    queue_.push_back(frames);
    ++taken_;
  }
  wake_.notify_one();
}

void WandCollector::run(const std::stop_token& stop) {
  setThreadPriority(ThreadPriority::Patient);
  while (!stop.stop_requested()) {
    FrameSetPtr frames;
    {
      std::unique_lock lock(queueMutex_);
      if (!wake_.wait(lock, stop, [this] { return !queue_.empty(); })) {
        return;
      }
      frames = std::move(queue_.front());
      queue_.pop_front();
    }
    search(*frames);
  }
}

void WandCollector::search(const FrameSet& frames) {
  finder_.add(frames);
  auto found = finder_.takeViews();
  const double time = seconds(frames.time);
  const std::lock_guard lock(seenMutex_);
  ++searched_;
  first_ = first_.value_or(time);
  newest_ = std::max(newest_, time);
  for (std::size_t c = 0; c < found.size(); ++c) {
    const bool shown = c < frames.frames.size() && frames.frames[c] != nullptr;
    for (const MarkerObservation& view : found[c]) {
      const cv::Mat& image = frames.frames[c]->image;
      const int region = BoardCoverage::regionOf(view.pixel, image.cols, image.rows);
      ++cameras_[c].imageCoverage.cornerCounts.at(static_cast<std::size_t>(region));
    }
    cameras_[c].detectionCount += shown ? found[c].size() : 0;
    std::ranges::move(found[c], std::back_inserter(views_[c]));
  }
}

WandCollector::State WandCollector::state() const {
  State state;
  {
    const std::lock_guard lock(queueMutex_);
    state.waitingFrameSetCount = taken_;
    state.droppedFrameSetCount = dropped_;
  }
  const std::lock_guard lock(seenMutex_);
  state.durationSeconds = first_ ? newest_ - *first_ : 0.0;
  state.searchedFrameSetCount = searched_;
  state.waitingFrameSetCount -= searched_;
  state.cameras = cameras_;
  return state;
}

std::vector<std::vector<MarkerObservation>> WandCollector::views() const {
  const std::lock_guard lock(seenMutex_);
  return views_;
}

} // namespace dewpoint::setup
