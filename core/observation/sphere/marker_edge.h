// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Outline of a ball in an image, with the uncertainty of its center.
struct MarkerImage {
  SphereImage outline;
  double sigma = 0.0; ///< standard deviation of the center along each axis, pixels
};

/// Fits the outline of a ball in an image (CV_8UC3) with an accuracy of a few hundredths of a
/// pixel, starting from an outline that is off by about a pixel.
///
/// A mask of matching pixels would be biased: where ball and background mix in a pixel, the mask
/// ends sooner on the dark side of the ball than on the bright side. Instead, each pixel near the
/// outline is unmixed along spokes (rays from the center of the ball): color = p * ball + w *
/// background. The colors of ball and background are taken from the same spoke, a little farther in
/// and a little farther out. The ball covers the fraction 1 - w of the pixel, regardless of the
/// ball's brightness there. The sum of these fractions along the spoke gives the edge position,
/// regardless of blur. An ellipse is fitted robustly to the edges of all spokes.
///
/// Returns nothing if too few edges agree, because the ball is hidden or the object is not a ball.
std::optional<MarkerImage> fitBallEdge(const cv::Mat& bgr, const SphereImage& initial);

} // namespace dewpoint::observation
