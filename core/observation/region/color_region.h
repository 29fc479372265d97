// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/label_image.h"

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include <vector>

namespace dewpoint::observation {

/// Image region with the target color. Pixels.
struct ColorRegion {
  double area = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< covariance of the pixels, px²
  cv::Rect box;                                         ///< bounding box
  /// Number of rim pixels: at least one of the four neighbors has another color.
  int rimPixelCount = 0;
  int cutRimPixelCount = 0;    ///< number of rim pixels at the image border
  int hiddenRimPixelCount = 0; ///< number of rim pixels next to an object that may hide the target

  /// Returns the fraction of the rim, 0 to 1, where the image border or another object may cut off
  /// the region.
  double cutOffShare() const {
    return rimPixelCount > 0
               ? static_cast<double>(cutRimPixelCount + hiddenRimPixelCount) / rimPixelCount
               : 0.0;
  }
};

/// Returns the regions with the target color inside `window`, largest first. Pieces at most four
/// pixels apart form one region. Regions of fewer than `leastArea` pixels are treated as noise and
/// left out. The function computes the labels of the window as needed. If a region extends beyond
/// the window, only the part inside counts.
std::vector<ColorRegion> findRegions(LabelImage& labels, const cv::Rect& window, double leastArea);

/// Returns the union of two regions that have no pixel in common.
ColorRegion joined(const ColorRegion& one, const ColorRegion& other);

} // namespace dewpoint::observation
