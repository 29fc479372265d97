// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker_diagnostics.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::session {

/// Returns a copy of an image that is lightly tinted where the mask is not 0, so that details stay
/// visible. `tints` has the color for each value of the mask. `image` is CV_8UC3 (blue, green,
/// red); `mask` is CV_8UC1 of the same size; `tints` is 1 x 256, CV_8UC3.
cv::Mat tintedImage(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& tints);

/// Returns an image resized to `size` in pixels: averaged when shrinking, interpolated when
/// enlarging. Neither the image nor `size` may be empty.
cv::Mat fittedImage(const cv::Mat& image, const cv::Size& size);

/// Draws the contour of a mask onto `view`, the mask's camera image at any size. The contour is a
/// line in the color of the tint with a dark border. `view` is CV_8UC3 and is changed in place.
/// `mask` is CV_8UC1; `tints` (1 x 256, CV_8UC3) has the color for each value of the mask.
void drawMaskOutline(cv::Mat& view, const cv::Mat& mask, const cv::Mat& tints);

/// Returns an image enlarged to `size` in pixels without smoothing, so that each pixel becomes a
/// square. Neither the image nor `size` may be empty.
cv::Mat enlargedImage(const cv::Mat& image, const cv::Size& size);

/// Returns a likelihood map as a color image of the map's area, CV_8UC4 (blue, green, red, 255).
/// The colors become steadily lighter, from dark blue (LikelihoodMap::minLogLikelihood) through
/// purple and orange to light yellow (LikelihoodMap::maxLogLikelihood), so color-blind users can
/// read them. The area must not be empty.
cv::Mat likelihoodImage(const LikelihoodMap& map);

} // namespace dewpoint::session
