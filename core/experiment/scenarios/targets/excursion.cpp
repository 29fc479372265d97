// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/scenarios/targets/excursion.h"

#include <algorithm>

namespace dewpoint::experiment::scenarios {
namespace {

/// 0 before 0, 1 after 1, smooth between them.
double eased(double share) {
  const double t = std::clamp(share, 0.0, 1.0);
  return t * t * (3.0 - 2.0 * t);
}

} // namespace

Eigen::Vector3d Detour::operator()(double time) const {
  const double away = eased((time - beginTime) / reachSeconds) *
                      (1.0 - eased((time - holdEndTime()) / reachSeconds));
  const double turned = eased((time - holdBeginTime()) / holdSeconds);
  return basePath(time) + away * ((1.0 - turned) * out + turned * back);
}

Visibility visibilityOf(const simulation::RoomView& view, const Eigen::Vector3d& center,
                        double radius) {
  if (view.boundsOfSphere(center, radius).empty()) {
    return Visibility::None;
  }
  return isFullyVisible(view, center, radius) ? Visibility::Full : Visibility::Partial;
}

void addInvisibilityEvents(
    ScenarioDraft& draft,
    const std::function<bool(std::size_t camera, std::int64_t frame)>& isSeen) {
  using Kind = ScenarioEvent::Kind;
  const std::size_t cameras = draft.rig.size();
  std::vector<bool> seen(cameras, true);
  bool anySeen = true;
  for (std::int64_t frame = 0; frame < draft.frameCount; ++frame) {
    bool any = false;
    for (std::size_t camera = 0; camera < cameras; ++camera) {
      const bool now = isSeen(camera, frame);
      any = any || now;
      if (now != seen[camera]) {
        draft.events.push_back(
            {now ? Kind::UnseenEnd : Kind::UnseenBegin, frame, static_cast<int>(camera)});
        seen[camera] = now;
      }
    }
    if (any != anySeen) {
      draft.events.push_back({any ? Kind::UnseenEnd : Kind::UnseenBegin, frame, -1});
      anySeen = any;
    }
  }
}

} // namespace dewpoint::experiment::scenarios
