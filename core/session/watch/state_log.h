// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/session/frames/tracked_frame.h"

#include <string>
#include <vector>

namespace dewpoint::session {

/// CSV table of the states of a run's targets over time, with the reason for each state other than
/// `held` (confirmed by the cameras). The table has one row for every change of a target's state or
/// of its reason.
class StateLog {
public:
  explicit StateLog(const CameraRig& rig);

  /// Adds the states of the targets in one frame; `targets` are in the order of the record.
  void append(const FrameRecord& record, const std::vector<Target>& targets);
  /// Returns the table with columns time_s, frame (from 0), target, state (held, searching, lost,
  /// gone) and reason. The reason says why cameras do not confirm the target
  /// (describeUnconfirmedCameras()); it is empty while the target is held (confirmed by the
  /// cameras).
  const std::string& csv() const { return csv_; }

private:
  std::vector<std::string> cameras_;
  std::vector<std::string> last_; ///< state and reason last written for each target
  std::string csv_ = "time_s,frame,target,state,reason\n";
};

} // namespace dewpoint::session
