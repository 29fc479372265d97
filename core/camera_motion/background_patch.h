// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// A small patch of the background that is located again in later images to a fraction of a pixel,
/// independent of the light: gray levels count relative to their mean and contrast within the
/// patch.
class BackgroundPatch {
public:
  static constexpr int kSide = 19; ///< pixels

  /// Creates the patch centered on a pixel of an image (CV_8UC3). Nothing if the pixel is too close
  /// to the border, or if the image has too little structure in some direction to locate the patch
  /// along it.
  static std::optional<BackgroundPatch> at(const cv::Mat& image, const cv::Point& center);

  /// Position of the patch in another image.
  struct Match {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< from center(), in pixels
    double likeness = 0.0;                           ///< normalized correlation, -1 to 1
  };
  /// Locates the patch in an image, near `guess` (pixels from center()), by inverse compositional
  /// alignment (Baker and Matthews 2004, "Lucas-Kanade 20 years on") of a shift, normalized for
  /// mean and contrast. Nothing if the search diverges or leaves the image.
  std::optional<Match> find(const cv::Mat& image, const Eigen::Vector2d& guess) const;

  const cv::Point& center() const { return center_; }
  /// How well the patch can be located: smaller eigenvalue of the summed squared gradients, in
  /// squared gray levels.
  double structure() const { return structure_; }
  /// Covariance of a measured shift due to image noise, in square pixels: large along an edge.
  const Eigen::Matrix2d& shiftCovariance() const { return shiftCovariance_; }

private:
  BackgroundPatch() = default;

  cv::Point center_;
  std::vector<float> values_; ///< kSide x kSide, mean 0, sum of squares 1
  std::vector<float> gradientX_, gradientY_;
  Eigen::Matrix2d inverseHessian_;
  Eigen::Matrix2d shiftCovariance_;
  double structure_ = 0.0;
};

} // namespace dewpoint::camera_motion
