// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/floors.h"

#include <Eigen/Core>
#include <opencv2/core.hpp>

namespace dewpoint::simulation {

// The renderer produces the gray levels of a camera with the tone curve of Recommendation ITU-R
// BT.709. Effects of light and sensor are computed in linear light, where 1 corresponds to level
// 255.

/// Exponent of the tone curve (from linear light to gray levels) above its linear segment near
/// black.
inline constexpr double kToneCurveExponent = 0.45;

/// Returns the gray level (1 corresponds to 255) that the tone curve assigns to `linear` light,
/// which must be at least 0. Levels above 1 are not clipped.
double encodedLevel(double linear);
/// Returns the linear light of a gray level (1 corresponds to 255). This is the inverse of
/// encodedLevel().
double linearLevel(double encoded);

/// Returns the linear light (CV_32FC3) of an image (CV_32FC3, BGR). Gray levels of the image are
/// normally 0 to 255. Levels above kMaxLevel are treated as kMaxLevel.
cv::Mat linearImage(const cv::Mat& image);
/// Largest gray level that linearImage() distinguishes; higher levels are limited to this level.
/// Chosen as four times full scale, which corresponds to 19 times the light at full scale.
inline constexpr float kMaxLevel = 1020.0F;

/// Converts linear light (CV_32FC3) to the gray levels of a camera (CV_32FC3, 0 to 255). The light
/// is multiplied by the white balance gains (BGR), limited to 1, and converted by the tone curve.
/// The exponent `contrast` is applied to the result; an exponent of 1 has no effect.
cv::Mat applyToneCurve(const cv::Mat& linear, const Eigen::Vector3d& whiteBalance, double contrast);

} // namespace dewpoint::simulation
