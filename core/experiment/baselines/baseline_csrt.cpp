// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/experiment/baselines/baseline_csrt.h"

#include <algorithm>
#include <cmath>

namespace dewpoint::experiment {
namespace {

/// Pixels; smaller boxes are widened about their center: CSRT learns from the pixels within.
constexpr int kLeastEdge = 8;

cv::Rect widened(const cv::Rect& box, const cv::Size& image) {
  const int width = std::max(box.width, kLeastEdge);
  const int height = std::max(box.height, kLeastEdge);
  const cv::Rect wide(box.x - (width - box.width) / 2, box.y - (height - box.height) / 2, width,
                      height);
  return wide & cv::Rect({0, 0}, image);
}

} // namespace

bool CsrtFollower::start(const CameraImages& images, const cv::Rect& box) {
  follower_ = makeOpenCvFollower("csrt");
  const cv::Rect wide = widened(box, images.bgr.size());
  const ImageBox first{static_cast<double>(wide.x), static_cast<double>(wide.y),
                       static_cast<double>(wide.width), static_cast<double>(wide.height)};
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
