// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/session/watch/state_log.h"

#include "core/tracking/camera_report.h"
#include "core/trajectory/csv_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace dewpoint::session {
namespace {

const char* stateName(TargetStatus status) {
  switch (status) {
  case TargetStatus::Searching:
    return "searching";
  case TargetStatus::Held:
    return "held";
  case TargetStatus::Ambiguous:
    return "ambiguous";
  case TargetStatus::Lost:
    return "lost";
  case TargetStatus::Gone:
    break;
  }
  return "gone";
}

} // namespace

StateLog::StateLog(const CameraRig& rig) {
  for (const Camera& camera : rig) {
    cameras_.push_back(camera.name);
  }
}

void StateLog::append(const FrameRecord& record, const std::vector<Target>& targets) {
  const std::size_t count = std::min(record.targets.size(), targets.size());
  last_.resize(std::max(last_.size(), count));
  for (std::size_t k = 0; k < count; ++k) {
    const FrameRecord::Entry& entry = record.targets[k];
    std::string state =
        fmt::format("{},{}", stateName(entry.status),
                    csvCell(describeUnconfirmedCameras(entry.cameraReports, cameras_)));
    if (state != last_[k]) {
      csv_ += fmt::format("{:.6f},{},{},{}\n", record.time, record.frame, csvCell(targets[k].name),
                          state);
      last_[k] = std::move(state);
    }
  }
}

} // namespace dewpoint::session
