// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/rerun_range.h"

#include "core/tracking/catalog/method_catalog.h"

#include <algorithm>

namespace dewpoint::session {
namespace {

/// The frame at which tracking with another method must begin so that `from` can be tracked.
std::int64_t startFrame(const RunWithHistory& current, const command::SetMethod& method,
                        std::int64_t from) {
  // Of the same targets, both methods can do what one can; others are tracked from the beginning.
  const MethodFamily family = current.run().definition()->family();
  const std::int64_t begin = family.tracksSameTargetsAs(methodFamily(method.method))
                                 ? family.firstFrameFor(current.run().targets(), from)
                                 : 0;
  return current.timeTravel().nearestFrame(begin).value_or(from);
}

} // namespace

std::optional<RerunState> framesToRerun(const RunWithHistory& current, const Playback& playback,
                                        std::int64_t from, const command::SetMethod* method) {
  const auto nearest = current.timeTravel().nearestFrame(from);
  if (!nearest) {
    return std::nullopt;
  }
  const std::int64_t head = current.headFrame();
  RerunState range{method != nullptr ? startFrame(current, *method, *nearest) : *nearest, head};
  if (const auto underWay = playback.rerunRange()) {
    // What lies ahead of it is tracked again anyway, and so is a head that was only taken.
    const bool isUntracked = playback.headProgress() == Playback::HeadProgress::Taken;
    range.firstFrame = std::min(range.firstFrame, isUntracked ? head : playback.nextFrame());
    range.lastFrame = std::max(range.lastFrame, underWay->lastFrame);
  }
  return range;
}

} // namespace dewpoint::session
