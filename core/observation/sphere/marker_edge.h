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

/// Fits the outline of a ball to a few hundredths of a pixel, from an initial outline that is off
/// by about a pixel.
///
/// A mask of matching pixels ends where a mixture of ball and background no longer matches. That
/// depends on the light: it ends sooner on the dark side of a ball than on the bright side. Each
/// pixel near the outline is therefore unmixed instead: color = p * ball + w * background, with the
/// colors a little farther in and out on the same spoke. 1 - w is the share that the ball covers,
/// whatever its brightness there. The sum of the shares along the spoke gives the position of the
/// edge, whatever the blur. An ellipse is fitted robustly to the edges of all spokes. Returns
/// nothing if too few agree: the ball is hidden, or it is no ball.
std::optional<MarkerImage> fitBallEdge(const cv::Mat& bgr, const SphereImage& initial);

} // namespace dewpoint::observation
