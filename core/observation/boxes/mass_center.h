// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Matching pixels in an image; fewer are noise. Origin not recorded.
inline constexpr int kLeastMassPixels = 4;

/// The center of mass of all pixels of an image (CV_8UC3) that match, pixels (column, row); nothing
/// when fewer than kLeastMassPixels do, or there is no image (Barrera et al. 2005, section III-C).
std::optional<Eigen::Vector2d> massCenter(const cv::Mat& bgr, const ColorClassifier& classifier);

} // namespace dewpoint::observation
