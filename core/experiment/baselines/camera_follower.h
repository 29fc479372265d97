// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <memory>
#include <optional>

namespace dewpoint::experiment {

/// Images of one camera at one frame; both are empty if there is no image.
struct CameraImages {
  cv::Mat bgr;  ///< CV_8UC3
  cv::Mat mask; ///< mask of the target's color, as from matchImage()
};

/// Position at which a follower sees the target. Pixel centers are at integer coordinates.
struct FollowedPixel {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< column, row
  double radiusPx = 0.0;                            ///< approximate size of the followed object
};

/// Follows one target through the images of one camera, starting from a box. It uses neither other
/// cameras nor the target's size.
class CameraFollower {
public:
  virtual ~CameraFollower() = default;
  /// Starts with the content of the box as the target. Returns false if it cannot start there.
  virtual bool start(const CameraImages& images, const cv::Rect& box) = 0;
  /// Position of the target in the next images, which must not be empty; nothing if the target is
  /// lost.
  virtual std::optional<FollowedPixel> step(const CameraImages& images) = 0;
};

/// Makes a follower for one target in one camera.
using CameraFollowerFactory = std::unique_ptr<CameraFollower> (*)();

} // namespace dewpoint::experiment
