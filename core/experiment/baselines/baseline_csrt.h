// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"
#include "core/experiment/boxes/box_follower.h"

namespace dewpoint::experiment {

/// Follower (of one target in one camera's images) that uses OpenCV's CSRT tracker (Lukežič et al.
/// 2017) with default parameters. It works on the camera image and does not use the color mask. The
/// reported position is the center of the tracker's box. The follower loses the target when CSRT
/// reports a failure, or when the box center is outside the image.
class CsrtFollower final : public CameraFollower {
public:
  bool start(const CameraImages& images, const cv::Rect& box) override;
  std::optional<FollowedPixel> step(const CameraImages& images) override;

private:
  std::unique_ptr<BoxFollower> follower_;
};

} // namespace dewpoint::experiment
