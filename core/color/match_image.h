// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/color/color_classifier.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::color {

/// Classifies a whole image: CV_8UC1 of the same size, 255 where the color matches, 0 elsewhere.
/// `bgr` is CV_8UC3; other types give an empty image.
cv::Mat matchImage(const cv::Mat& bgr, const ColorClassifier& classifier);

/// Classifies a whole image into `match`, which is reused from frame to frame so that no memory is
/// allocated.
void matchImage(const cv::Mat& bgr, const ColorClassifier& classifier, cv::Mat& match);

} // namespace dewpoint::color
