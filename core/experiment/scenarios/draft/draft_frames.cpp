// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/draft_frames.h"

#include "core/base/random.h"
#include "core/experiment/scenarios/draft/camera_timing.h"

#include <cmath>
#include <memory>
#include <utility>

namespace dewpoint::experiment::scenarios {
namespace {

/// The number of the newest frame that a camera has taken by `time`; negative: none yet.
std::int64_t newestFrame(const CameraClock& clock, double time) {
  constexpr double kRounding = 1e-6; // of a frame: taken exactly at `time` counts
  return static_cast<std::int64_t>(
      std::floor((time - clock.offsetSeconds) * clock.framesPerSecond + kRounding));
}

/// The frame that a camera contributes to set `frame`; null when there is none.
FramePtr frameOf(const ScenarioDraft& draft, std::size_t camera, std::int64_t frame) {
  if (draft.lost && draft.lost(camera, frame)) {
    return nullptr;
  }
  CameraClock clock{draft.framesPerSecond, 0.0};
  std::int64_t own = frame;
  if (!draft.clocks.empty()) {
    clock = draft.clocks.at(camera);
    own = newestFrame(clock, draft.timeOf(frame));
    if (own < 0 || (frame > 0 && own == newestFrame(clock, draft.timeOf(frame - 1)))) {
      return nullptr;
    }
  }
  const CameraTiming timing = draft.timings.empty() ? CameraTiming{} : draft.timings.at(camera);
  const RandomStream chances(draft.stage.seed, static_cast<std::uint32_t>(own),
                             static_cast<std::uint32_t>(camera), RandomPurpose::Start);
  const auto delivery = deliveryOf(timing, own, chances);
  if (!delivery) {
    return nullptr;
  }
  const auto stampOf = [&](std::int64_t number) {
    return clock.offsetSeconds + static_cast<double>(number) / clock.framesPerSecond;
  };
  const double taken = midExposureTime(timing, stampOf(delivery->shownFrame));
  return std::make_shared<const Frame>(
      Frame{own, timeStamp(stampOf(own) + delivery->timeStampError),
            simulation::renderStage(draft.stage, camera, taken, delivery->shownFrame)});
}

} // namespace

FrameSetPtr frameSetOf(const ScenarioDraft& draft, std::int64_t frame) {
  FrameSet set{frame, timeStamp(draft.timeOf(frame)), {}};
  for (std::size_t camera = 0; camera < draft.rig.size(); ++camera) {
    set.frames.push_back(frameOf(draft, camera, frame));
  }
  return std::make_shared<const FrameSet>(std::move(set));
}

} // namespace dewpoint::experiment::scenarios
