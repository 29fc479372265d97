// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tracking/tracker_diagnostics.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::session {

/// An image as a view shows it with a mask over it: as it is where the mask is 0, elsewhere lightly
/// tinted with the color that `tints` has for the mask's value, so that what lies over it can be
/// read. `image` is CV_8UC3 (blue, green, red) and may be shared; `mask` is CV_8UC1 of its size;
/// `tints` is 1 x 256, CV_8UC3.
cv::Mat tintedImage(const cv::Mat& image, const cv::Mat& mask, const cv::Mat& tints);

/// An image in the size, in pixels, that a view has for it: averaged where it gets smaller,
/// interpolated where it gets larger. Neither is empty.
cv::Mat fittedImage(const cv::Mat& image, const cv::Size& size);

/// Draws the contour of a mask into a view of its image of any size: inside, a line of the tint,
/// and around it a dark one. `view` is CV_8UC3 and not shared; `mask` and `tints` as above.
void outlineMask(cv::Mat& view, const cv::Mat& mask, const cv::Mat& tints);

/// An image in a larger size, its pixels as squares. Neither is empty.
cv::Mat enlargedImage(const cv::Mat& image, const cv::Size& size);

/// A likelihood map as a picture of its area: from dark blue (LikelihoodMap::least) over purple and
/// orange to light yellow (most), rising in lightness, so that it can be read without telling red
/// from green. CV_8UC4: blue, green, red, 255. The area is not empty.
cv::Mat likelihoodImage(const LikelihoodMap& map);

} // namespace dewpoint::session
