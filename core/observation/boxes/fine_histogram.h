// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// A color histogram of fine bins (fineRgbBin()), smoothed over neighboring bins; it sums to 1, or
/// to 0 where there are no pixels.
using FineHistogram = std::vector<double>;

/// Share below which a color cannot be told from chance: one pixel of a thousand. Origin not
/// recorded.
inline constexpr double kChanceShare = 1e-3;

/// The pixels of a box that lie in the image.
cv::Rect pixelsOf(const ImageBox& box, const cv::Mat& image);

/// The histogram of a part of an image (CV_8UC3).
FineHistogram fineHistogramOf(const cv::Mat& bgr, const cv::Rect& part);

/// The histogram of the pixels of a box; they count by 1 - r² (Epanechnikov's kernel, equation 6 of
/// Sugandi et al. 2009), where r is 1 on the ellipse that touches the sides: what a box is drawn
/// around lies in its center.
FineHistogram centralHistogramOf(const cv::Mat& bgr, const ImageBox& box);

/// The histogram of the surroundings of a box: of a ring (70 %) and of all else (30 %), what the
/// target may come to.
FineHistogram surroundingsOf(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
