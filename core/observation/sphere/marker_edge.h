// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/geometry/sphere_image.h"

#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// A ball's outline in an image, with how well its center is known.
struct MarkerImage {
  SphereImage outline;
  double sigma = 0.0; ///< standard deviation of the center along each axis, pixels
};

/// Fits the outline of a ball from an initial one (a pixel or so off), to a few hundredths of a
/// pixel.
///
/// A mask of matching pixels ends where a mixture of ball and background no longer matches, which
/// depends on the light: on the dark side of a ball sooner than on the bright one. So each pixel
/// near the outline is unmixed instead: color = p * ball + w * background, with the colors a little
/// farther in and out on the same spoke; 1 - w is the share that the ball covers, however bright it
/// is there, and the sum of the shares along the spoke is where the edge lies, however blurred. The
/// edges of all spokes make an ellipse, robustly. Nothing when too few agree: hidden, or no ball.
std::optional<MarkerImage> fitBallEdge(const cv::Mat& bgr, const SphereImage& initial);

} // namespace dewpoint::observation
