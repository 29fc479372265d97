// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>
#include <vector>

namespace dewpoint::camera_motion {

/// A small piece of the background that is found again in later images to a fraction of a pixel,
/// whatever the light: gray levels count relative to their mean and contrast within the patch.
class BackgroundPatch {
public:
  static constexpr int kSide = 19; ///< pixels

  /// The patch centered on a pixel of an image (CV_8UC3); nothing too near to the border, nor where
  /// the picture has too little structure in any direction to be located along it.
  static std::optional<BackgroundPatch> at(const cv::Mat& image, const cv::Point& center);

  struct Match {
    Eigen::Vector2d shift = Eigen::Vector2d::Zero(); ///< pixels, from center()
    double likeness = 0.0;                           ///< normalized correlation, -1 to 1
  };
  /// Where the patch is in an image, near `guess` (pixels from center()): inverse compositional
  /// alignment (Baker and Matthews 2004, "Lucas-Kanade 20 years on") of a shift, normalized for
  /// mean and contrast. Nothing when it runs off or leaves the image.
  std::optional<Match> find(const cv::Mat& image, const Eigen::Vector2d& guess) const;

  const cv::Point& center() const { return center_; }
  /// How well it can be located: the smaller eigenvalue of the summed squared gradients, in the
  /// square of gray levels.
  double structure() const { return structure_; }
  /// Of a shift that is found, by the noise of an image, square pixels: poor along an edge.
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
