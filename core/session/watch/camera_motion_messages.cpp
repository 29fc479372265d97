// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/camera_motion_messages.h"

namespace dewpoint::session {

CameraMotionStage stageOf(const CameraMotionReport& report, double now) {
  if (report.isBackInPose) {
    return CameraMotionStage::Back;
  }
  if (report.newPose) {
    return CameraMotionStage::Solved;
  }
  return now - seconds(report.event.time) > kPoseSearchTimeout ? CameraMotionStage::Unsolvable
                                                               : CameraMotionStage::Waiting;
}

CameraMotionMessages::NewMessages
CameraMotionMessages::update(const std::vector<CameraMotionReport>& reports, double now) {
  NewMessages news;
  if (reports.size() < count_) {
    reported_.clear();
    news.withdrawsEarlierMessages = true;
  }
  count_ = reports.size();
  for (const CameraMotionReport& report : reports) {
    const CameraMotionStage stage = stageOf(report, now);
    const auto key = [&](CameraMotionStage one) {
      return std::tuple(report.event.camera, report.event.frame, one);
    };
    const bool worse =
        stage == CameraMotionStage::Waiting || stage == CameraMotionStage::Unsolvable;
    if (!(worse && reported_.contains(key(CameraMotionStage::Solved))) &&
        reported_.insert(key(stage)).second) {
      news.messages.push_back({report, stage});
    }
  }
  return news;
}

void CameraMotionMessages::clear() {
  reported_.clear();
  count_ = 0;
}

} // namespace dewpoint::session
