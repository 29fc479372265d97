// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

#include <cstdint>
#include <limits>
#include <vector>

namespace dewpoint::experiment {

/// Returns a mask of the pixels whose centers are in a convex polygon: CV_8UC1 with the given
/// `size`, 255 inside, otherwise 0. Corners are in pixels, clockwise or counterclockwise, and may
/// be outside the image. If there are fewer than three corners, the mask is zero everywhere.
cv::Mat filledOutline(const std::vector<Eigen::Vector2d>& outline, cv::Size size);

/// Overlap of an estimated silhouette with the true silhouette of a body in an image, in pixels.
struct SilhouetteOverlap {
  std::int64_t commonPixelCount = 0; ///< number of estimated pixels on the visible body
  std::int64_t truePixelCount = 0;   ///< number of pixels of the visible body
  std::int64_t estimatedPixelCount =
      0; ///< number of estimated pixels, excluding the hidden part of the body

  double recall() const;    ///< returns common / true pixels; NaN if nothing is visible
  double precision() const; ///< returns common / estimated pixels; NaN for an empty estimate
  double iou() const; ///< returns intersection / union of estimate and truth; NaN if both are empty
};

/// Returns the overlap of an estimated silhouette with the true one. All masks have equal size
/// (CV_8UC1, nonzero inside): the estimate, the visible part of the body, and the whole body.
/// Pixels where the body is hidden are ignored.
SilhouetteOverlap overlapOf(const cv::Mat& estimate, const cv::Mat& visible, const cv::Mat& whole);

/// Mean scores over silhouettes. NaN if there were no silhouettes.
struct SilhouetteScores {
  double recall = std::numeric_limits<double>::quiet_NaN();
  double precision = std::numeric_limits<double>::quiet_NaN();
  double iou = std::numeric_limits<double>::quiet_NaN();
};

} // namespace dewpoint::experiment
