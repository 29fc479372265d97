// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/run/frame_loop.h"

#include <algorithm>
#include <utility>

namespace dewpoint::session {

Result<bool> trackFrame(TrackingRun& run, FrameObservers observers, FrameStep step) {
  for (int left = run.iterationsPerFrame() - run.frameIterationCount(); left > 0; --left) {
    const double microseconds = run.iterateTimed();
    for (FrameObserver* const observer : observers) {
      observer->onIteration(run, microseconds);
    }
    if (step == FrameStep::OneIteration && left > 1) {
      return false;
    }
  }
  for (FrameObserver* const observer : observers) {
    if (const auto told = observer->onFrameTracked(run); !told) {
      return tl::make_unexpected(told.error());
    }
  }
  return true;
}

Status trackOneFrame(TrackingRun& run, FrameObservers observers) {
  const auto isDone = trackFrame(run, observers);
  return isDone ? Status() : tl::make_unexpected(isDone.error());
}

Status trackOneFrame(TrackingRun& run, FrameSetPtr frames, FrameObservers observers) {
  for (FrameObserver* const observer : observers) {
    observer->onFrameTaken(*frames);
  }
  run.beginFrame(std::move(frames));
  return trackOneFrame(run, observers);
}

bool hasImages(const FrameSet& frames) {
  return std::ranges::any_of(frames.frames, [](const FramePtr& frame) { return frame != nullptr; });
}

std::optional<std::int64_t> FrameRange::countIn(const FrameSetSource& source) const {
  const auto total = source.frameCount();
  if (!total && !end) {
    return std::nullopt;
  }
  const std::int64_t last = total && end ? std::min(*end, *total) : end.value_or(total.value_or(0));
  return std::max<std::int64_t>(0, last - first);
}

Status trackFrames(FrameSetSource& source, const FrameRange& range, TrackingRun& run,
                   FrameObservers observers, const std::function<bool()>& shouldContinue) {
  if (range.first > 0) {
    if (const auto sought = source.seek(range.first); !sought) {
      return sought;
    }
  }
  const auto count = range.countIn(source);
  for (std::int64_t done = 0; shouldContinue() && (!count || done < *count);) {
    auto frames = source.next();
    if (!frames) {
      return tl::make_unexpected(frames.error());
    }
    if (!*frames) {
      break;
    }
    if (!hasImages(**frames)) {
      continue;
    }
    if (const auto tracked = trackOneFrame(run, std::move(*frames), observers); !tracked) {
      return tracked;
    }
    ++done;
  }
  return {};
}

} // namespace dewpoint::session
