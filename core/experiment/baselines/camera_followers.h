// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"

#include <cstddef>
#include <vector>

namespace dewpoint::experiment {

/// Followers of one target, at most one per camera.
class CameraFollowers {
public:
  /// If `make` is null, no camera ever has a follower.
  CameraFollowers(CameraFollowerFactory make, std::size_t cameraCount)
      : make_(make), followers_(cameraCount) {}

  /// Removes all followers.
  void forget();
  bool follows(std::size_t camera) const { return followers_[camera] != nullptr; }
  /// Replaces the follower of this camera by a new one; none if it cannot start there.
  void start(std::size_t camera, const CameraImages& images, const cv::Rect& box);
  /// Positions at which each camera's follower sees the target in the next images, in the order of
  /// the rig. A follower that is lost is removed; one without an image waits.
  std::vector<std::optional<FollowedPixel>> step(const std::vector<CameraImages>& images);

private:
  CameraFollowerFactory make_;
  std::vector<std::unique_ptr<CameraFollower>> followers_;
};

} // namespace dewpoint::experiment
