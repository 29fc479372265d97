// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/sugandi_study.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Draws a picture like figures 2 and 3 of Sugandi et al. 2009: five frames of a clip, four evenly
/// spaced and the one with the largest error of 100 particles. The boxes and centers found with 100
/// particles (upper row) and with 300 (lower row) are red, the true box is white. CV_8UC3.
cv::Mat boxFrames(const std::vector<cv::Mat>& images, const std::vector<ImageBox>& truth,
                  const BoxRow& few, const BoxRow& many);

/// Plots of a clip as HTML: x, y and error of the centers over the frames, and its frames.
std::string boxFiguresHtml(const BoxStudy& study, std::size_t clip);
/// File name of the picture of a clip's frames.
std::string boxFramesFile(std::size_t clip);
/// Plots of a clip as HTML, like figure 1 of Sugandi et al. 2009: the color histograms of the given
/// box and of the box found halfway through the clip.
std::string boxHistogramsHtml(const BoxStudy& study, std::size_t clip);
/// CSV with one row per clip and bin that is not empty in both histograms.
std::string boxHistogramsCsv(const BoxStudy& study);
/// CSV with one row per clip, method and frame of the first run; the truth is listed as a method.
std::string boxTracksCsv(const BoxStudy& study);

} // namespace dewpoint::experiment
