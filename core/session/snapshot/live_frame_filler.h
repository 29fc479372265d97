// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/session/snapshot/snapshot.h"

#include <vector>

namespace dewpoint::session {

/// Fills in missing images of live cameras for display. Cameras that are not synchronized do not
/// deliver an image in every frame set. A view then shows the last image of its camera for a while,
/// so that the view does not flicker and users can click in it. The tracker does not process this
/// image twice.
class LiveFrameFiller {
public:
  /// Returns the snapshot for display. In a live run, cameras without an image get their last one
  /// (and its mask) if it is younger than kMaxImageAgeSeconds. Other snapshots are returned
  /// unchanged.
  TrackSnapshotPtr withMissingImages(const TrackSnapshotPtr& snapshot);

  static constexpr double kMaxImageAgeSeconds =
      0.5; ///< largest age of an image that is shown again

private:
  std::vector<FramePtr> frames_; ///< last image of each camera
  std::vector<cv::Mat> masks_;
};

} // namespace dewpoint::session
