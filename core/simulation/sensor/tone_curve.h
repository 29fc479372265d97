// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

// The gray levels of the renderer are those of a camera with the tone curve of Recommendation ITU-R
// BT.709. Effects of light and sensor are computed in linear light, in which 1 gives level 255.

/// Exponent of the curve above its linear segment near black.
inline constexpr double kToneCurvePower = 0.45;

/// Returns the level (1 for 255) of `linear` light (>= 0; not clipped above 1).
double encodedLevel(double linear);
/// Returns the linear light of a level; the inverse of encodedLevel().
double linearLevel(double encoded);

/// Returns the linear light (CV_32FC3) of an image (CV_32FC3, BGR, 0 to 255; up to kBrightestLevel
/// above).
cv::Mat linearImage(const cv::Mat& image);
/// Largest level; higher ones are limited to it. Four times full scale, 19 times its light; chosen.
inline constexpr float kBrightestLevel = 1020.0F;

/// Last steps of a camera: multiplies linear light (CV_32FC3) by the white balance gains (BGR),
/// limits it to 1, and applies the tone curve and then the exponent `contrast` (1: the curve
/// itself). Returns CV_32FC3, 0 to 255.
cv::Mat tonedImage(const cv::Mat& linear, const Eigen::Vector3d& whiteBalance, double contrast);

} // namespace dewpoint::simulation
