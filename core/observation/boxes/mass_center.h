// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Least number of matching pixels in an image; fewer are noise. Origin not recorded.
inline constexpr int kLeastMassPixels = 4;

/// Center of mass of all matching pixels of an image (CV_8UC3), pixels (column, row). Returns
/// nothing for fewer than kLeastMassPixels, or without an image (Barrera et al. 2005, section
/// III-C).
std::optional<Eigen::Vector2d> massCenter(const cv::Mat& bgr, const ColorClassifier& classifier);

} // namespace dewpoint::observation
