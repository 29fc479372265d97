// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/draft/camera_timing.h"

#include <algorithm>

namespace dewpoint::experiment::scenarios {

std::optional<FrameDelivery> deliveryOf(const CameraTiming& timing, std::int64_t frame,
                                        const RandomStream& chances) {
  FrameDelivery delivery{frame, timing.jitterSeconds * chances.normal4(2)[0]};
  if (frame <= 0) {
    return delivery;
  }
  if (chances.uniform(0) < timing.droppedFrameShare) {
    return std::nullopt;
  }
  if (frame >= timing.freezeBegin && frame < timing.freezeEnd) {
    delivery.shownFrame = std::max<std::int64_t>(0, timing.freezeBegin - 1);
  } else if (chances.uniform(1) < timing.repeatedFrameShare) {
    delivery.shownFrame = frame - 1;
  }
  return delivery;
}

double midExposureTime(const CameraTiming& timing, double stamp) {
  return stamp - timing.delaySeconds - timing.clockDrift * stamp;
}

} // namespace dewpoint::experiment::scenarios
