// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_csrt.h"

#include <cmath>

namespace dewpoint::experiment {

bool CsrtFollower::start(const CameraImages& images, const cv::Rect& box) {
  follower_ = makeOpenCvFollower("csrt");
  const ImageBox first{static_cast<double>(box.x), static_cast<double>(box.y),
                       static_cast<double>(box.width), static_cast<double>(box.height)};
  if (!follower_->start(images.bgr, first)) {
    follower_.reset();
  }
  return follower_ != nullptr;
}

std::optional<FollowedPixel> CsrtFollower::step(const CameraImages& images) {
  const auto box = follower_ ? follower_->step(images.bgr) : std::nullopt;
  if (!box || box->isEmpty()) {
    return std::nullopt;
  }
  // From the image's corner to the middle of its first pixel.
  const Eigen::Vector2d center = box->center() - Eigen::Vector2d(0.5, 0.5);
  const bool inside = center.x() >= 0.0 && center.y() >= 0.0 &&
                      center.x() <= images.bgr.cols - 1.0 && center.y() <= images.bgr.rows - 1.0;
  return inside ? std::optional(FollowedPixel{center, 0.5 * std::sqrt(box->area())}) : std::nullopt;
}

} // namespace dewpoint::experiment
