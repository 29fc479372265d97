// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::color {

/// Classifies a whole image. Returns CV_8UC1 of the same size, 255 where the color matches, 0
/// elsewhere. `bgr` is CV_8UC3; for other types, the result is empty.
cv::Mat matchImage(const cv::Mat& bgr, const ColorClassifier& classifier);

/// Classifies a whole image and writes the result to `match`. Reuse `match` from frame to frame to
/// avoid allocating memory.
void matchImage(const cv::Mat& bgr, const ColorClassifier& classifier, cv::Mat& match);

} // namespace dewpoint::color
