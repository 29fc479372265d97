// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/run/snapshot.h"

#include <vector>

namespace dewpoint::session {

/// Live cameras that run freely do not all have an image in each set of frames. A view that went
/// blank for each one would flicker, and nobody could click in it: so views show the last image of
/// such a camera for a while. The tracker never sees it twice.
class LiveFrameFiller {
public:
  /// The snapshot as views show it: of a live run, cameras without an image now have their last
  /// one (and its mask) if that is younger than kYoung. Anything else comes back as it is.
  TrackSnapshotPtr filled(const TrackSnapshotPtr& snapshot);

  static constexpr double kYoung = 0.5; ///< seconds

private:
  std::vector<FramePtr> frames_; ///< the last one of each camera
  std::vector<cv::Mat> masks_;
};

} // namespace dewpoint::session
