// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Small patch of the background that can be located in later images with subpixel accuracy. Before
/// patches are compared, their gray levels are normalized to the same mean and contrast, so that
/// changes in lighting have no effect.
class BackgroundPatch {
public:
  static constexpr int kSide = 19; ///< pixels

  /// Creates a patch centered on a pixel of an image (CV_8UC3). Returns nothing if the pixel is too
  /// close to the border, or if the image has too little structure in some direction to locate the
  /// patch in that direction.
  static std::optional<BackgroundPatch> at(const cv::Mat& image, const cv::Point& center);

  /// Position of the patch in another image.
  struct Match {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< displacement from center(), pixels
    double correlation = 0.0;                        ///< normalized correlation, -1 to 1
  };
  /// Locates the patch in an image. The search starts at the displacement `guess` (pixels from
  /// center()). Method: inverse compositional alignment (Baker and Matthews 2004, "Lucas-Kanade 20
  /// years on"), with the displacement as the only unknown, after mean and contrast are normalized.
  /// Returns nothing if the search diverges, ends more than 6 pixels from `guess`, or leaves the
  /// image.
  std::optional<Match> find(const cv::Mat& image, const Eigen::Vector2d& guess) const;

  const cv::Point& center() const { return center_; }
  /// Returns how well the patch can be located. For each pixel, the product of the gray-level
  /// gradient and its transpose is a 2 x 2 matrix. The result is the smaller eigenvalue of the sum
  /// of these matrices over the patch, in squared gray levels per px².
  double structure() const { return structure_; }
  /// Returns the covariance of a measured shift due to image noise, in square pixels. If the patch
  /// shows only an edge, the variance along this edge is large.
  const Eigen::Matrix2d& shiftCovariance() const { return shiftCovariance_; }

private:
  BackgroundPatch() = default;

  cv::Point center_;
  std::vector<float> values_; ///< kSide x kSide values with mean 0 and sum of squares 1
  std::vector<float> gradientX_, gradientY_;
  Eigen::Matrix2d inverseHessian_;
  Eigen::Matrix2d shiftCovariance_;
  double structure_ = 0.0;
};

} // namespace dewpoint::camera_motion
