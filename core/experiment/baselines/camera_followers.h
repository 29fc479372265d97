// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"

#include <cstddef>
#include <vector>

namespace dewpoint::experiment {

/// Followers of one target: each follows the target through the images of one camera.
class CameraFollowers {
public:
  /// Creates an object without followers for this number of cameras. If `make` is null, no camera
  /// ever gets a follower.
  CameraFollowers(CameraFollowerFactory make, std::size_t cameraCount)
      : make_(make), followers_(cameraCount) {}

  /// Removes all followers.
  void clear();
  bool hasFollower(std::size_t camera) const { return followers_[camera] != nullptr; }
  /// Replaces the follower of this camera by a new one that starts in `box`. If it cannot start
  /// there, the camera has no follower afterward.
  void start(std::size_t camera, const CameraImages& images, const cv::Rect& box);
  /// Returns the target position that each camera's follower finds in the next images, in rig
  /// order. The entry of a camera is empty if it has no follower or no image, or if the follower
  /// loses the target. A follower that loses the target is removed. A follower whose camera has no
  /// image is kept for later frames.
  std::vector<std::optional<FollowedPixel>> step(const std::vector<CameraImages>& images);

private:
  CameraFollowerFactory make_;
  std::vector<std::unique_ptr<CameraFollower>> followers_;
};

} // namespace dewpoint::experiment
