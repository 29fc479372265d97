// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/observation/sphere/marker_edge.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Finds a ball for calibration by its color alone, with an accuracy of a fraction of a pixel.
/// Reports no ball rather than an uncertain result.
class MarkerDetector {
public:
  explicit MarkerDetector(const ColorClassifier& classifier) : classifier_(classifier) {}

  /// Returns the ball in an image (CV_8UC3): the largest patch with the ball's color, with an
  /// outline fitted by fitBallEdge(). Returns nothing if the patch is not as round as a complete
  /// ball, touches the image border, has a radius below kMinRadiusPixels, or has less than twice
  /// the total area of all other patches.
  std::optional<MarkerImage> find(const cv::Mat& bgr);

  static constexpr double kMinRadiusPixels =
      2.0; ///< pixels; the reason for this value is not recorded

private:
  ColorClassifier classifier_;
  cv::Mat match_, labels_, stats_, middles_; ///< buffers, reused for each frame
};

} // namespace dewpoint::observation
