// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/camera.h"
#include "core/session/frames/tracked_frame.h"

#include <string>
#include <vector>

namespace dewpoint::session {

/// Why the targets of a run were held or not, as a CSV table to be read beside the trajectory: a
/// row whenever the state of a target changes, or the reason for it.
class ReasonLog {
public:
  explicit ReasonLog(const CameraRig& rig);

  /// After each frame; targets in the order of the record.
  void append(const FrameRecord& record, const std::vector<Target>& targets);
  /// time_s, frame (from 0), target, state (held, searching, lost, gone) and the reason as
  /// reasonSentence() words it; empty while held.
  const std::string& csv() const { return csv_; }

private:
  std::vector<std::string> cameras_;
  std::vector<std::string> last_; ///< per target, state and reason as they were written
  std::string csv_ = "time_s,frame,target,state,reason\n";
};

} // namespace dewpoint::session
