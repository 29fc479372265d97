// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>
#include <opencv2/core/types.hpp>

#include <memory>
#include <optional>

namespace dewpoint::experiment {

/// Image of one camera in one frame, and its color mask. Both are empty if there is no image.
struct CameraImages {
  cv::Mat bgr;  ///< image, CV_8UC3 (BGR)
  cv::Mat mask; ///< mask of the target's color, as from matchImage()
};

/// Target position found by a follower, in pixels. Pixel centers are at integer coordinates.
struct FollowedPixel {
  Eigen::Vector2d center = Eigen::Vector2d::Zero(); ///< center of the target: column, row
  double radiusPx = 0.0; ///< approximate radius of the followed object, pixels
};

/// Follows one target through the images of one camera, starting from a box. It uses neither the
/// other cameras nor the target size.
class CameraFollower {
public:
  virtual ~CameraFollower() = default;
  /// Starts following the object in the box. Returns false if the follower cannot start there.
  virtual bool start(const CameraImages& images, const cv::Rect& box) = 0;
  /// Returns the target position in the next images, or nothing if the target is lost. The images
  /// must not be empty.
  virtual std::optional<FollowedPixel> step(const CameraImages& images) = 0;
};

/// Creates a follower for one target in one camera.
using CameraFollowerFactory = std::unique_ptr<CameraFollower> (*)();

} // namespace dewpoint::experiment
