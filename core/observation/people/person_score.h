// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/clothes_model.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Scores that a moving and a still pixel of a standing body add, in units of a fully visible body.
/// Motion is evidence for a person, and no motion is evidence against one. The values follow
/// approximately from log(0.6 / 0.03) and log(0.4 / 0.97), because masks have holes.
inline constexpr double kMovingPixel = 1.0;
inline constexpr double kStillPixel = -0.3;

/// Converts a mask (CV_8UC1, 0 or 255) to scores stored as bytes (see ScoreSums). Pixels where
/// `explained` (CV_8UC1, or empty) is nonzero get a score of 0.
cv::Mat maskScores(const cv::Mat& mask, const cv::Mat& explained);

/// Adds color evidence for one person against other people to the scores of the moving pixels in an
/// area. `ratio` has a table of log ratios for the rows above `waist` and one for the rows from
/// `waist` on.
void addColorScores(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& area, int waist,
                    const ClothesRatio& ratio, double weight, cv::Mat& scores);

} // namespace dewpoint::observation
