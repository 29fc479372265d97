// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/clothes_model.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// What a pixel of a standing body adds to its score, in units of a fully visible one: motion
/// speaks for a person, none against one. Origin: about log(0.6 / 0.03) against log(0.4 / 0.97):
/// masks have holes.
inline constexpr double kMovingPixel = 1.0;
inline constexpr double kStillPixel = -0.3;

/// The scores of a mask (CV_8UC1, 0 or 255) as bytes (see ScoreSums), with nothing where
/// `explained` (CV_8UC1, or empty) is nonzero.
cv::Mat maskScores(const cv::Mat& mask, const cv::Mat& explained);

/// Adds to the moving pixels of an area what their colors say for one person against others.
/// `upper` and `lower` are tables of log ratios by color bin, used above and from `waist` (row) on.
void addColorScores(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& area, int waist,
                    const ClothesRatio& ratio, double weight, cv::Mat& scores);

} // namespace dewpoint::observation
