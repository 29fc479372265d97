// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_ranges.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::color {

/// A pixel is taken for background if each channel differs from the background image by at most
/// this many gray levels (sensor noise) plus an eighth of its usual value (small changes of the
/// light).
inline constexpr int kFamiliarLevels = 14;
inline constexpr int kFamiliarShift = 3;

/// The images (CV_8UC3) with black, which no range matches, where they have a color of the ranges
/// but so did the background image: a tracker that has it does not take that for a target.
/// `rooms` are the background images in the same order; an empty one, or one of another size,
/// leaves its image as it is. An image in which nothing is familiar shares its pixels with the
/// result.
std::vector<cv::Mat> withoutBackgroundColors(const ColorRanges& ranges,
                                             const std::vector<cv::Mat>& images,
                                             const std::vector<cv::Mat>& rooms);

} // namespace dewpoint::color
