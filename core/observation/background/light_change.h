// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core/mat.hpp>

#include <optional>

namespace dewpoint::observation {

/// Estimates the factor per channel (blue, green, red) by which a whole image is brighter, darker
/// or differently tinted than a learned background. The factor is the median ratio over a grid of
/// pixels.
///
/// `image` and `mean` are CV_8UC3 of one size. `confidence` (CV_8UC1) tells where the mean is
/// known: its values there are at least BackgroundModel::kLearned. `light` is the light to which
/// the mean corresponds, relative to a reference light.
///
/// Returns nothing in these cases:
/// - The light is about the same.
/// - No factor explains most of the image, because an object covers it or the camera was moved.
/// - The factor, or its product with `light`, is too large for a light change.
std::optional<Eigen::Array3d> estimateLightChange(const cv::Mat& image, const cv::Mat& mean,
                                                  const cv::Mat& confidence,
                                                  const Eigen::Array3d& light);

} // namespace dewpoint::observation
