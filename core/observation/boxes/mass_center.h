// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Minimum number of matching pixels in an image; fewer pixels are treated as noise. The reason for
/// this value is not recorded.
inline constexpr int kMinMassPixels = 4;

/// Returns the center of mass of all matching pixels in an image (CV_8UC3), in pixels (column, row)
/// (Barrera et al. 2005, section III-C). Returns nothing for fewer than kMinMassPixels matching
/// pixels or without an image.
std::optional<Eigen::Vector2d> centerOfMass(const cv::Mat& bgr, const ColorClassifier& classifier);

} // namespace dewpoint::observation
