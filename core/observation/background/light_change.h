// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Returns the factors, one per channel (blue, green, red), by which a whole image is brighter or
/// darker than a learned background. Different factors mean another tint. A factor is the median
/// ratio over a grid of pixels.
///
/// `image` and `mean` are CV_8UC3 of one size. The mean is known where `confidence` (CV_8UC1) is at
/// least BackgroundModel::kObservationsUntilKnown. `light` is the light to which the mean
/// corresponds, relative to a reference light.
///
/// Returns nothing in these cases:
/// - The light is about the same.
/// - No factors explain most of the image, because an object covers the image or the camera was
///   moved.
/// - A factor, or its product with `light`, is too large for a light change.
std::optional<Eigen::Array3d> estimateLightChange(const cv::Mat& image, const cv::Mat& mean,
                                                  const cv::Mat& confidence,
                                                  const Eigen::Array3d& light);

} // namespace dewpoint::observation
