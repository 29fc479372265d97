// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/rewind/time_travel.h"

#include "core/session/frames/live_frames.h"
#include "core/session/frames/recorded_frames.h"

#include <algorithm>
#include <utility>

namespace dewpoint::session {
namespace {

/// Particles kept of each target and frame.
constexpr int kParticlesKept = 500;

} // namespace

TimeTravel::TimeTravel(FrameSetSource& source, std::size_t bytes)
    : history_(HistoryLimits::forTotal(bytes, source.isLive())) {
  const std::size_t most = history_.limits().imageBytes;
  if (source.isLive()) {
    auto live = makeLiveFrameCache(most);
    liveCache_ = live.get();
    cache_ = std::move(live);
  } else {
    cache_ = makeRecordedFrameCache(source, most);
  }
}

void TimeTravel::clear() {
  history_.clear();
  if (liveCache_ != nullptr) {
    liveCache_->clear();
  }
  probe_.reset();
  probeNext_.reset();
}

void TimeTravel::noteFrameBegin(const FrameSetPtr& frames, const TrackingRun& run) {
  cache_->add(frames);
  if (liveCache_ != nullptr) {
    history_.forgetBefore(liveCache_->oldestFrame());
  }
  history_.noteFrameBegin(frames->index, run);
}

void TimeTravel::recordChange(const TrackingRun& run, const RunChange& change) {
  if (run.frames()) {
    history_.recordChange(run.frames()->index, run.frameIterationCount(), change);
  }
}

const TrackedFrame& TimeTravel::record(const TrackingRun& run) {
  const std::int64_t frame = run.frames()->index;
  history_.record(run.trackedFrame(kParticlesKept, history_.before(frame)));
  return *history_.newest();
}

std::optional<std::int64_t> TimeTravel::nearestFrame(std::int64_t frame) const {
  const std::int64_t newest = cache_->newestFrame();
  return newest < 0 ? std::nullopt
                    : std::optional(std::clamp(frame, cache_->oldestFrame(), newest));
}

std::optional<std::int64_t> TimeTravel::nextShowable(std::int64_t frame) const {
  return frame < cache_->newestFrame() ? nearestFrame(frame + 1) : std::nullopt;
}

Result<FrameSetPtr> TimeTravel::previewAt(std::int64_t frame, bool& preview) {
  bool exact = true;
  const FrameSetPtr frames = cache_->previewAt(frame, exact);
  preview = frames && !exact;
  return frames ? frames : cache_->at(frame);
}

HistoryState TimeTravel::state() const {
  HistoryState state;
  state.firstFrame = cache_->oldestFrame();
  state.lastFrame = cache_->newestFrame();
  state.memoryBytes = history_.memoryBytes() + cache_->memoryBytes();
  state.maxMemoryBytes = history_.limits().totalBytes();
  if (const TrackedFrame* newest = history_.newest()) {
    state.newestTrackedFrame = newest->frame;
  }
  return state;
}

Status TimeTravel::trackAgain(TrackingRun& run, const TrackedFrame& trackedFrame) {
  const auto frames = cache_->at(trackedFrame.frame);
  if (!frames) {
    return tl::make_unexpected(frames.error());
  }
  run.beginFrame(*frames);
  for (int done = 0; done <= trackedFrame.iterationCount; ++done) {
    for (const RunChange& change : history_.changesAt(trackedFrame.frame, done)) {
      run.apply(change);
    }
    if (done < trackedFrame.iterationCount) {
      run.iterateTimed();
    }
  }
  return {};
}

bool TimeTravel::restoreCheckpoint(TrackingRun& run, std::int64_t frame, std::int64_t& next) const {
  if (const History::Checkpoint* checkpoint = history_.checkpointFor(frame)) {
    run.restore(checkpoint->state);
    next = checkpoint->frame;
    return true;
  }
  // A method that cannot be copied goes over everything again, as long as there are images.
  const auto& begun = history_.methodStart();
  const bool again =
      begun && begun->frame < frame && begun->frame >= cache_->oldestFrame() && !run.canBeCopied();
  next = again ? begun->frame : frame;
  if (again) {
    run.apply(begun->state.definition);
  }
  const TrackedFrame* before = history_.before(next);
  run.restart(run.definition()->seed);
  run.setIterationCount(before != nullptr ? before->totalIterationCount : 0);
  return again;
}

Result<std::int64_t> TimeTravel::goBack(TrackingRun& run, std::int64_t frame,
                                        const ShouldContinue& shouldContinue) {
  std::int64_t next = frame;
  if (!restoreCheckpoint(run, frame, next)) {
    return frame;
  }
  const TrackedFrame* trackedFrame = history_.at(next);
  trackedFrame = trackedFrame != nullptr ? trackedFrame : history_.after(next);
  for (; trackedFrame != nullptr && trackedFrame->frame < frame;
       trackedFrame = history_.after(trackedFrame->frame)) {
    if (!shouldContinue()) {
      return trackedFrame->frame;
    }
    if (const auto repeated = trackAgain(run, *trackedFrame); !repeated) {
      return tl::make_unexpected(repeated.error());
    }
  }
  return frame;
}

const TrackingRun* TimeTravel::runAt(std::int64_t frame, const TrackingRun& run,
                                     const ShouldContinue& shouldContinue) {
  const History::Checkpoint* checkpoint = history_.checkpointFor(frame);
  if (history_.at(frame) == nullptr || checkpoint == nullptr) {
    return nullptr;
  }
  const bool near =
      probe_ && probeNext_ && *probeNext_ <= frame && *probeNext_ >= checkpoint->frame;
  if (!near) {
    auto probe = TrackingRun::create(checkpoint->state.definition, run.threadCount());
    if (!probe) {
      return nullptr;
    }
    probe_.emplace(std::move(*probe));
    probe_->restore(checkpoint->state);
    probeNext_ = checkpoint->frame;
  }
  const TrackedFrame* next = history_.at(*probeNext_);
  next = next != nullptr ? next : history_.after(*probeNext_);
  for (; next != nullptr && next->frame <= frame; next = history_.after(next->frame)) {
    if (!shouldContinue() || !trackAgain(*probe_, *next)) {
      probe_.reset();
      return nullptr;
    }
    probeNext_ = next->frame + 1;
  }
  return &*probe_;
}

void TimeTravel::setThreadCount(int threadCount) {
  if (probe_) {
    probe_->setThreadCount(threadCount);
  }
}

} // namespace dewpoint::session
