// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"
#include "core/observation/sphere/marker_edge.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Finds a ball by its color alone, for calibration: sub-pixel, and rather nothing than something
/// wrong.
class MarkerDetector {
public:
  explicit MarkerDetector(const ColorClassifier& classifier) : classifier_(classifier) {}

  /// The one ball in the image (CV_8UC3): the largest patch of its color, if that is round like the
  /// outline of a whole ball, away from the border, at least kLeastRadius large and larger than all
  /// others together, its outline then fitted to the colors (fitBallEdge).
  std::optional<MarkerImage> find(const cv::Mat& bgr);

  static constexpr double kLeastRadius = 2.0; ///< pixels

private:
  ColorClassifier classifier_;
  cv::Mat match_, labels_, stats_, middles_; ///< kept from frame to frame
};

} // namespace dewpoint::observation
