// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// Tolerance in gray levels for sensor noise. A pixel is treated as background if each channel
/// differs from the background image by at most this tolerance plus an eighth of the channel's
/// usual value. The additional eighth covers small changes in lighting.
inline constexpr int kBackgroundTolerance = 14;
inline constexpr int kBackgroundToleranceShift = 3;

/// Returns the images (CV_8UC3) with background pixels that match the ranges replaced by black,
/// which no range matches. A pixel is background if it hardly differs from the background image
/// (kBackgroundTolerance). Trackers that use background images therefore do not mistake these
/// pixels for a target. `backgroundImages` contains the background images in the same order. If one
/// is empty or has a different size, the image is left unchanged. An image without such pixels
/// shares its memory with the result.
std::vector<cv::Mat> withoutBackgroundColors(const ColorRanges& ranges,
                                             const std::vector<cv::Mat>& images,
                                             const std::vector<cv::Mat>& backgroundImages);

} // namespace dewpoint::color
