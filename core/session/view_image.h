// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker_diagnostics.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::session {

/// Returns an image with a mask drawn over it. Where the mask is 0, the image is unchanged.
/// Elsewhere it is lightly tinted, so that details stay visible; `tints` has the color for each
/// value of the mask. `image` is CV_8UC3 (blue, green, red) and may be shared; `mask` is CV_8UC1 of
/// the same size; `tints` is 1 x 256, CV_8UC3.
cv::Mat tintedImage(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& tints);

/// Returns an image resized to the size of its view, in pixels: averaged when shrinking,
/// interpolated when enlarging. Neither size is empty.
cv::Mat fittedImage(const cv::Mat& image, const cv::Size& size);

/// Draws the contour of a mask onto a view of its image, which may have any size. The contour is a
/// line in the color of the tint with a dark border. `view` is CV_8UC3 and not shared; `mask` and
/// `tints` are as for tintedImage().
void outlineMask(cv::Mat& view, const cv::Mat& mask, const cv::Mat& tints);

/// Returns an enlarged image in which each pixel is a square. Neither size is empty.
cv::Mat enlargedImage(const cv::Mat& image, const cv::Size& size);

/// Returns a likelihood map as an image of its area. The colors go from dark blue
/// (LikelihoodMap::least) through purple and orange to light yellow (LikelihoodMap::most). They
/// become steadily lighter, so the map can be read without distinguishing red from green. CV_8UC4:
/// blue, green, red, 255. The area must not be empty.
cv::Mat likelihoodImage(const LikelihoodMap& map);

} // namespace dewpoint::session
