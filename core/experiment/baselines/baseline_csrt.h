// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"
#include "core/experiment/boxes/box_follower.h"

namespace dewpoint::experiment {

/// OpenCV's CSRT (Lukežič et al. 2017) with default parameters, on the camera's image; it does not
/// use the color mask. The position is the center of its box. It is lost when it reports so, or
/// when that center is outside the image.
class CsrtFollower final : public CameraFollower {
public:
  bool start(const CameraImages& images, const cv::Rect& box) override;
  std::optional<FollowedPixel> step(const CameraImages& images) override;

private:
  std::unique_ptr<BoxFollower> follower_;
};

} // namespace dewpoint::experiment
