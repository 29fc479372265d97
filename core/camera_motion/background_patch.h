// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// Small patch of the background that can be located in later images with an accuracy of a fraction
/// of a pixel. The gray levels are normalized to the same mean and contrast before a comparison, so
/// that changes in lighting have no effect.
class BackgroundPatch {
public:
  static constexpr int kSidePx = 19; ///< side of the square patch, pixels

  /// Creates a patch centered on a pixel of an image (CV_8UC3). Returns nothing if the pixel is too
  /// close to the border, or if the image has too little structure in some direction to locate the
  /// patch in that direction.
  static std::optional<BackgroundPatch> at(const cv::Mat& image, const cv::Point& center);

  /// Position of the patch in another image.
  struct Match {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< displacement from center(), pixels
    double correlation = 0.0;                        ///< normalized correlation, -1 to 1
  };
  /// Returns the position of the patch in an image. The search starts at the displacement `guess`
  /// (pixels from center()). Method: inverse compositional alignment (Baker and Matthews 2004,
  /// "Lucas-Kanade 20 years on"), with the displacement as the only unknown. Returns nothing if the
  /// search diverges, ends more than 6 pixels from `guess`, or leaves the image.
  std::optional<Match> find(const cv::Mat& image, const Eigen::Vector2d& guess) const;

  const cv::Point& center() const { return center_; }
  /// Returns a measure of how well the patch can be located: the smaller eigenvalue of the
  /// structure tensor, in squared gray levels per px². The structure tensor is the sum of g g' over
  /// all pixels of the patch, where g is the gray-level gradient at a pixel.
  double minEigenvalue() const { return minEigenvalue_; }
  /// Returns the covariance (px²) of a measured shift that results from image noise. If the patch
  /// shows only an edge, the variance along this edge is large.
  const Eigen::Matrix2d& shiftCovariance() const { return shiftCovariance_; }

private:
  BackgroundPatch() = default;

  cv::Point center_;
  std::vector<float> values_; ///< kSidePx x kSidePx values with mean 0 and sum of squares 1
  std::vector<float> gradientX_, gradientY_;
  Eigen::Matrix2d inverseHessian_;
  Eigen::Matrix2d shiftCovariance_;
  double minEigenvalue_ = 0.0;
};

} // namespace dewpoint::camera_motion
