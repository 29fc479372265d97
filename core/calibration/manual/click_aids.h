// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::calibration {

/// Finds the corner nearest to a click within `reach` pixels, refined to a fraction of a pixel
/// (cv::cornerSubPix; Förstner and Gülch 1987). Nothing if there is no corner. `image`: CV_8UC3 or
/// CV_8UC1; pixel centers are at integers.
std::optional<Eigen::Vector2d> snapToCorner(const cv::Mat& image, const Eigen::Vector2d& click,
                                            double reach);

/// Magnified square section of an image around a pixel: `side` pixels wide, each image pixel drawn
/// as `factor` x `factor`, with the pixel `center` at the center of the result. Pixels outside the
/// image are black.
cv::Mat magnified(const cv::Mat& image, const Eigen::Vector2d& center, int side, int factor);

/// Edge strength of an image (Sobel), 0 to 255: CV_8UC1 of the image's size.
cv::Mat edgePicture(const cv::Mat& image);
/// Edge strength of an image after resizing it to `size`, which is not empty.
cv::Mat edgePicture(const cv::Mat& image, const cv::Size& size);

} // namespace dewpoint::calibration
