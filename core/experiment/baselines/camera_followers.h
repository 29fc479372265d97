// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/baselines/camera_follower.h"

#include <cstddef>
#include <vector>

namespace dewpoint::experiment {

/// The followers of one target, at most one per camera.
class CameraFollowers {
public:
  /// `make` may be null: then there never is a follower.
  CameraFollowers(CameraFollowerFactory make, std::size_t cameraCount)
      : make_(make), followers_(cameraCount) {}

  void forget();
  bool follows(std::size_t camera) const { return followers_[camera] != nullptr; }
  /// A new follower for this camera, in place of what it had; none if it cannot start there.
  void start(std::size_t camera, const CameraImages& images, const cv::Rect& box);
  /// Where each camera's follower sees the target in the next images, in the order of the rig. One
  /// that is lost is dropped; one without an image waits.
  std::vector<std::optional<FollowedPixel>> step(const std::vector<CameraImages>& images);

private:
  CameraFollowerFactory make_;
  std::vector<std::unique_ptr<CameraFollower>> followers_;
};

} // namespace dewpoint::experiment
