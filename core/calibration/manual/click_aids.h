// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::calibration {

/// Finds the corner that is closest to a click and at most `reach` pixels away, and refines its
/// position to a fraction of a pixel (cv::cornerSubPix; Förstner and Gülch 1987). Returns nothing
/// if there is no corner. `image`: CV_8UC3 or CV_8UC1; pixel centers are at integers.
std::optional<Eigen::Vector2d> snapToCorner(const cv::Mat& image, const Eigen::Vector2d& click,
                                            double reach);

/// Returns a magnified square section of an image. It is `side` pixels wide, shows each image pixel
/// as `factor` x `factor` pixels, and has the pixel `center` at its center. Areas outside the image
/// are black.
cv::Mat magnified(const cv::Mat& image, const Eigen::Vector2d& center, int side, int factor);

/// Returns the edge strength of an image (Sobel), 0 to 255, as CV_8UC1 with the size of the image.
cv::Mat edgeStrengthImage(const cv::Mat& image);
/// Returns the edge strength of an image after resizing it to `size`, which must not be empty.
cv::Mat edgeStrengthImage(const cv::Mat& image, const cv::Size& size);

} // namespace dewpoint::calibration
