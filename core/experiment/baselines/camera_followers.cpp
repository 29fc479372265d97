// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/camera_followers.h"

#include <algorithm>

namespace dewpoint::experiment {

void CameraFollowers::clear() {
  for (auto& follower : followers_) {
    follower.reset();
  }
}

void CameraFollowers::start(std::size_t camera, const CameraImages& images, const cv::Rect& box) {
  if (make_ == nullptr) {
    return;
  }
  followers_[camera] = make_();
  if (!followers_[camera]->start(images, box)) {
    followers_[camera].reset();
  }
}

std::vector<std::optional<FollowedPixel>>
CameraFollowers::step(const std::vector<CameraImages>& images) {
  std::vector<std::optional<FollowedPixel>> pixels(followers_.size());
  for (std::size_t camera = 0; camera < std::min(followers_.size(), images.size()); ++camera) {
    if (!followers_[camera] || images[camera].bgr.empty()) {
      continue;
    }
    pixels[camera] = followers_[camera]->step(images[camera]);
    if (!pixels[camera]) {
      followers_[camera].reset();
    }
  }
  return pixels;
}

} // namespace dewpoint::experiment
