// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// Color histogram with fine bins (fineRgbBin()), smoothed over neighboring bins. It sums to 1, or
/// to 0 if there are no pixels.
using FineHistogram = std::vector<double>;

/// Share below which a color cannot be distinguished from chance: one pixel in a thousand. Origin
/// not recorded.
inline constexpr double kChanceShare = 1e-3;

/// Pixels of a box that lie in the image.
cv::Rect pixelsOf(const ImageBox& box, const cv::Mat& image);

/// Histogram of a part of an image (CV_8UC3).
FineHistogram fineHistogramOf(const cv::Mat& bgr, const cv::Rect& part);

/// Histogram of the pixels of a box, weighted by 1 - r² (Epanechnikov's kernel, equation 6 of
/// Sugandi et al. 2009). r is 1 on the ellipse that touches the sides. The object for which a box
/// is drawn lies in its center.
FineHistogram centralHistogramOf(const cv::Mat& bgr, const ImageBox& box);

/// Histogram of the surroundings of a box: a ring (70 %) and the rest of the image (30 %), through
/// which the target may move.
FineHistogram surroundingsOf(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
