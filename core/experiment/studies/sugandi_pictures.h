// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/sugandi_study.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// As Sugandi et al. 2009, figures 2 and 3: five frames of a clip, four evenly picked and the one
/// at which 100 particles are farthest off, with the box and its center as found with 100 particles
/// (upper row) and with 300 (lower row), red, and the true box, white. CV_8UC3.
cv::Mat boxFrames(const std::vector<cv::Mat>& images, const std::vector<ImageBox>& truth,
                  const BoxRow& few, const BoxRow& many);

/// Of a clip: x, y and error of the centers over the frames, as plots in HTML, and its frames.
std::string boxFiguresHtml(const BoxStudy& study, std::size_t clip);
/// How the picture of a clip's frames is called.
std::string boxFramesFile(std::size_t clip);
/// Of a clip, as Sugandi et al. 2009, figure 1: the color histogram of the given box and that of
/// the box found in the middle of the clip, as plots in HTML.
std::string boxHistogramsHtml(const BoxStudy& study, std::size_t clip);
/// A row per clip and bin that is not empty in both histograms.
std::string boxHistogramsCsv(const BoxStudy& study);
/// A row per clip, method and frame of the first run; the truth as a method of its own.
std::string boxTracksCsv(const BoxStudy& study);

} // namespace dewpoint::experiment
