// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

// The gray levels of the renderer are those of a camera with the tone curve of Recommendation
// ITU-R BT.709. What light and a sensor do happens in linear light: 1 is what gives level 255.

/// Power of the curve above its straight piece near black.
inline constexpr double kToneCurvePower = 0.45;

/// The curve itself: the level, 1 for 255, of `linear` light (>= 0; above 1 not clipped).
double encodedLevel(double linear);
/// Its inverse.
double linearLevel(double encoded);

/// Linear light (CV_32FC3) of an image (CV_32FC3, BGR, 0 to 255; up to kBrightestLevel above).
cv::Mat linearImage(const cv::Mat& image);
/// Levels from here on count as this one: four times full scale, 19 times its light; chosen.
inline constexpr float kBrightestLevel = 1020.0F;

/// The last steps of a camera: linear light (CV_32FC3) times the gains of white balance (BGR), cut
/// at 1, through the tone curve, and that to the power of `contrast` (1: the curve itself).
/// CV_32FC3, 0 to 255.
cv::Mat tonedImage(const cv::Mat& linear, const Eigen::Vector3d& whiteBalance, double contrast);

} // namespace dewpoint::simulation
