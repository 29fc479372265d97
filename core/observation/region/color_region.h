// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/background/label_image.h"

#include <Eigen/Core>
#include <opencv2/core/types.hpp>

#include <vector>

namespace dewpoint::observation {

/// A region of an image in the target's color, by its moments. Pixels.
struct ColorRegion {
  double area = 0.0;
  Eigen::Vector2d centroid = Eigen::Vector2d::Zero();
  Eigen::Matrix2d covariance = Eigen::Matrix2d::Zero(); ///< second central moments, px²
  cv::Rect box;                                         ///< the pixels it lies in
  int rim = 0;       ///< pixels of it that have a neighbor (of four) which is not its color
  int cutRim = 0;    ///< of these, at the border of the image
  int hiddenRim = 0; ///< of these, beside something that may hide the target

  /// Share of the rim, 0 to 1, where the image or something else may end the region before the
  /// target does.
  double openShare() const { return rim > 0 ? static_cast<double>(cutRim + hiddenRim) / rim : 0.0; }
};

/// The regions of the target's color within `window`, largest first. Pieces that are at most four
/// pixels apart are one; those of fewer than `leastArea` pixels are noise. Makes the labels of the
/// window. A region that the window cuts is counted as far as it lies inside.
std::vector<ColorRegion> findRegions(LabelImage& labels, const cv::Rect& window, double leastArea);

/// The moments of two regions together.
ColorRegion joined(const ColorRegion& one, const ColorRegion& other);

} // namespace dewpoint::observation
