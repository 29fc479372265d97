// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/image_box.h"

#include <opencv2/core/mat.hpp>

#include <vector>

namespace dewpoint::observation {

/// Color histogram with fine bins (fineRgbBin()), smoothed over neighboring bins. The sum of a
/// histogram is 1, or 0 if there are no pixels.
using FineHistogram = std::vector<double>;

/// Minimum fraction of the pixels that must have a color; a rarer color may be there by chance. The
/// reason for this value is not recorded.
inline constexpr double kChanceShare = 1e-3;

/// Returns the rectangle of the pixels of a box that lie inside the image.
cv::Rect clippedToImage(const ImageBox& box, const cv::Mat& image);

/// Computes the histogram of a part of an image (CV_8UC3).
FineHistogram fineHistogramOf(const cv::Mat& bgr, const cv::Rect& part);

/// Computes the histogram of the pixels in a box, weighted by 1 - r² (Epanechnikov's kernel,
/// equation 6 of Sugandi et al. 2009), where r is 0 at the center and 1 on the ellipse that touches
/// the box sides. Pixels near the center count more, because they are more likely to show the
/// object.
FineHistogram centralHistogramOf(const cv::Mat& bgr, const ImageBox& box);

/// Computes the histogram of a box's surroundings: a ring around the box (weight 70 %) and the rest
/// of the image (weight 30 %), through which the target may move.
FineHistogram surroundingsHistogramOf(const cv::Mat& bgr, const ImageBox& box);

} // namespace dewpoint::observation
