// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace dewpoint::experiment {

/// The pixels whose centers lie in a convex polygon: CV_8UC1 of `size`, 255 inside, else 0. Corners
/// in pixels, clockwise or counterclockwise, also outside the image; no pixel for fewer than three.
cv::Mat filledOutline(const std::vector<Eigen::Vector2d>& outline, cv::Size size);

/// How an estimated silhouette lies on the true one of a body in an image, in pixels.
struct SilhouetteOverlap {
  std::int64_t both = 0;     ///< of the estimate, on what is visible of the body
  std::int64_t truth = 0;    ///< of what is visible of the body
  std::int64_t estimate = 0; ///< of the estimate, except where the body is but something hides it

  double recall() const;    ///< both / truth; NaN when nothing is visible
  double precision() const; ///< both / estimate; NaN for an empty estimate
  double iou() const;       ///< both / (truth or estimate); NaN when there is neither
};

/// Compares masks of one size (CV_8UC1, not 0 inside): the estimate, what is visible of the body,
/// and the whole body whether visible or not. Where the body is hidden, an estimate is neither
/// right nor wrong.
SilhouetteOverlap overlapOf(const cv::Mat& estimate, const cv::Mat& visible, const cv::Mat& whole);

/// Means over silhouettes; NaN when there were none.
struct SilhouetteScores {
  double recall = std::numeric_limits<double>::quiet_NaN();
  double precision = std::numeric_limits<double>::quiet_NaN();
  double iou = std::numeric_limits<double>::quiet_NaN();
};

} // namespace dewpoint::experiment
