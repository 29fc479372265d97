// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"

namespace dewpoint::experiment {

/// Follower (of one target in one camera's images) that uses OpenCV's CamShift (Bradski 1998). The
/// color mask is its probability image, so it uses the same pixels as the other methods. The
/// follower loses the target when its search window contains no pixel of the target's color. The
/// reported position is the center of mass of the matching pixels in the window, not the rounded
/// center that CamShift returns.
class CamShiftFollower final : public CameraFollower {
public:
  bool start(const CameraImages& images, const cv::Rect& box) override;
  std::optional<FollowedPixel> step(const CameraImages& images) override;

private:
  cv::Rect window_;
};

} // namespace dewpoint::experiment
