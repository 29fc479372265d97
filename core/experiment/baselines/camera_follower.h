// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <memory>
#include <optional>

namespace dewpoint::experiment {

/// What one camera shows at one frame: both empty where there is no image.
struct CameraImages {
  cv::Mat bgr;  ///< CV_8UC3
  cv::Mat mask; ///< as from matchImage(), of the target's color
};

/// Where a follower sees the target. Pixel centers lie at integer coordinates.
struct FollowedPixel {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< column, row
  double radiusPx = 0.0;                            ///< of about the size of what it follows
};

/// Follows one target through the images of one camera, from a box on. It knows neither other
/// cameras nor the target's size.
class CameraFollower {
public:
  virtual ~CameraFollower() = default;
  /// Takes what is in the box as the target. False when it cannot start there.
  virtual bool start(const CameraImages& images, const cv::Rect& box) = 0;
  /// Where the target is in the next images; nothing when it is lost. They are not empty.
  virtual std::optional<FollowedPixel> step(const CameraImages& images) = 0;
};

/// Makes a follower for one target in one camera.
using CameraFollowerFactory = std::unique_ptr<CameraFollower> (*)();

} // namespace dewpoint::experiment
