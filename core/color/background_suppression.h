// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// Tolerance in gray levels for sensor noise. A pixel is treated as background if each channel
/// differs from the background image by at most this tolerance plus an eighth of the channel's
/// value in the background image. The additional eighth covers small changes in lighting.
inline constexpr int kBackgroundTolerance = 14;
inline constexpr int kBackgroundToleranceShift = 3;

/// Returns `images` (CV_8UC3) with those background pixels painted black whose color matches
/// `ranges`. No range matches black, so these pixels are not mistaken for a target. Trackers that
/// use background images see the scene in the same way. A pixel is background if it hardly differs
/// from the background image (kBackgroundTolerance). `backgroundImages` has the same order as
/// `images`. If a background image is empty or has a different size, the image is left unchanged.
/// An image without pixels to replace shares its memory with the result.
std::vector<cv::Mat> suppressBackgroundColors(const ColorRanges& ranges,
                                              const std::vector<cv::Mat>& images,
                                              const std::vector<cv::Mat>& backgroundImages);

} // namespace dewpoint::color
