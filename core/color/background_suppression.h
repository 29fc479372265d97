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

/// Copies of the images (CV_8UC3) in which pixels that have a color of the ranges, and had one in
/// the background image too, are black. Black matches no range, so a tracker with background images
/// does not take such pixels for a target. `rooms` are the background images in the same order; an
/// empty one, or one of another size, leaves its image unchanged. The result shares the pixels of
/// an image in which no pixel is taken for background.
std::vector<cv::Mat> withoutBackgroundColors(const ColorRanges& ranges,
                                             const std::vector<cv::Mat>& images,
                                             const std::vector<cv::Mat>& rooms);

} // namespace dewpoint::color
