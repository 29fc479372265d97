// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/observation/people/clothes_model.h"

#include <opencv2/core/mat.hpp>

namespace dewpoint::observation {

/// Scores of a moving pixel and of a still pixel within a person's silhouette. Motion is evidence
/// for a person, and no motion is evidence against a person. The scale is chosen so that a fully
/// visible body has the score 1. The two values are approximately proportional to log(0.6 / 0.03)
/// and log(0.4 / 0.97). A pixel is assumed to move with a probability of 0.6 on a person, because
/// masks have holes, and of 0.03 elsewhere.
inline constexpr double kMovingPixel = 1.0;
inline constexpr double kStillPixel = -0.3;

/// Converts a mask (CV_8UC1, 0 or 255) to scores stored as bytes (see ScoreSums). Pixels where
/// `explained` (CV_8UC1, or empty) is nonzero get a score of 0.
cv::Mat maskScores(const cv::Mat& mask, const cv::Mat& explained);

/// Adds the log ratio of the pixel's color, multiplied by `weight`, to the scores of the moving
/// pixels (nonzero in `mask`) in `area`. The log ratio says how much better the color fits one
/// person than other people. The log ratio is taken from `ratio[1]` for image rows above the row
/// `waist`, and from `ratio[0]` for the row `waist` and the rows below.
void addColorScores(const cv::Mat& image, const cv::Mat& mask, const cv::Rect& area, int waist,
                    const ClothesRatio& ratio, double weight, cv::Mat& scores);

} // namespace dewpoint::observation
