// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::calibration {

/// The corner nearest to a click within `reach` pixels, refined to a fraction of a pixel
/// (cv::cornerSubPix; Förstner and Gülch 1987). Nothing where there is no corner. `image`: CV_8UC3
/// or CV_8UC1; centers of pixels at integers.
std::optional<Eigen::Vector2d> snapToCorner(const cv::Mat& image, const Eigen::Vector2d& click,
                                            double reach);

/// A square piece of an image around a pixel, every pixel as `factor` x `factor`, so that this one
/// lies at the center of the result, `side` pixels wide. Pixels outside the image are black.
cv::Mat magnified(const cv::Mat& image, const Eigen::Vector2d& center, int side, int factor);

/// How strong the edges of an image are (Sobel), 0 to 255: CV_8UC1 of its size.
cv::Mat edgePicture(const cv::Mat& image);
/// The same of an image that was brought to another size first, which is not empty.
cv::Mat edgePicture(const cv::Mat& image, const cv::Size& size);

} // namespace dewpoint::calibration
