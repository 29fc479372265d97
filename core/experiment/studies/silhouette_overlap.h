// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace dewpoint::experiment {

/// Pixels whose centers are in a convex polygon: CV_8UC1 of `size`, 255 inside, otherwise 0.
/// Corners are in pixels, clockwise or counterclockwise, and may be outside the image. No pixel for
/// fewer than three corners.
cv::Mat filledOutline(const std::vector<Eigen::Vector2d>& outline, cv::Size size);

/// Overlap of an estimated silhouette with the true one of a body in an image, in pixels.
struct SilhouetteOverlap {
  std::int64_t both = 0;     ///< pixels of the estimate on the visible body
  std::int64_t truth = 0;    ///< pixels of the visible body
  std::int64_t estimate = 0; ///< pixels of the estimate, without the hidden part of the body

  double recall() const;    ///< both / truth; NaN when nothing is visible
  double precision() const; ///< both / estimate; NaN for an empty estimate
  double iou() const;       ///< both / union of the two; NaN if both are empty
};

/// Compares masks of one size (CV_8UC1, nonzero inside): the estimate, the visible part of the
/// body, and the whole body, visible or not. Where the body is hidden, an estimate is neither right
/// nor wrong.
SilhouetteOverlap overlapOf(const cv::Mat& estimate, const cv::Mat& visible, const cv::Mat& whole);

/// Means over silhouettes; NaN if there were none.
struct SilhouetteScores {
  double recall = std::numeric_limits<double>::quiet_NaN();
  double precision = std::numeric_limits<double>::quiet_NaN();
  double iou = std::numeric_limits<double>::quiet_NaN();
};

} // namespace dewpoint::experiment
