// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/frames/tracked_frame.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::session {

std::size_t TrackedFrame::memoryBytes() const {
  std::size_t sum = sizeof(TrackedFrame) + targets.capacity() * sizeof(TrackedTarget);
  for (const TrackedTarget& target : targets) {
    sum +=
        sizeof(float) * static_cast<std::size_t>(target.particles.size() + target.weights.size());
    sum += sizeof(float) * static_cast<std::size_t>(target.boxParticles.centers.size() +
                                                    target.boxParticles.weights.size());
    sum += target.positionCandidates.capacity() * sizeof(CandidatePosition);
    sum += target.cameraReports.capacity() * sizeof(CameraReport);
    sum += cameraEvidenceOf(target.estimate).capacity() * sizeof(CameraEvidence);
    for (const ColorRanges& colors : colorsOf(target.estimate)) {
      sum += sizeof(ColorRanges) + colors.size() * sizeof(ColorRange);
    }
  }
  return sum;
}

TargetStatus statusOf(bool held, double time, double lastHeldTime) {
  if (held) {
    return TargetStatus::Held;
  }
  return std::isfinite(lastHeldTime) && time - lastHeldTime >= kLostAfter ? TargetStatus::Lost
                                                                          : TargetStatus::Searching;
}

FrameRecord frameRecord(const TrackedFrame& trackedFrame, const FrameSet& frames) {
  FrameRecord record;
  record.frame = trackedFrame.frame;
  record.time = trackedFrame.time;
  for (std::size_t k = 0; k < std::min<std::size_t>(64, frames.frames.size()); ++k) {
    record.missingCameraBits |= frames.frames[k] ? 0 : std::uint64_t{1} << k;
  }
  for (const TrackedTarget& target : trackedFrame.targets) {
    const bool held = target.status == TargetStatus::Held || target.status == TargetStatus::Gone ||
                      target.status == TargetStatus::Ambiguous; // no camera contradicts it
    record.targets.push_back({target.status,
                              static_cast<float>(existenceProbabilityOf(target.estimate)),
                              held ? std::vector<CameraReport>() : target.cameraReports});
  }
  return record;
}

} // namespace dewpoint::session
