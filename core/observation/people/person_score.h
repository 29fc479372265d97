// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/clothes_model.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Score that a moving or still pixel of a standing body adds, in units of a fully visible one.
/// Motion is evidence for a person; no motion is evidence against one. Origin: about log(0.6 /
/// 0.03) and log(0.4 / 0.97), because masks have holes.
inline constexpr double kMovingPixel = 1.0;
inline constexpr double kStillPixel = -0.3;

/// Scores of a mask (CV_8UC1, 0 or 255) as bytes (see ScoreSums). Pixels where `explained`
/// (CV_8UC1, or empty) is nonzero get a score of 0.
cv::Mat maskScores(const cv::Mat& mask, const cv::Mat& explained);

/// Adds color evidence for one person against others to the moving pixels of an area. `ratio` has a
/// table of log ratios for the rows above `waist` and one for the rows from `waist` on.
void addColorScores(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& area, int waist,
                    const ClothesRatio& ratio, double weight, cv::Mat& scores);

} // namespace dewpoint::observation
