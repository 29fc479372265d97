// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/experiment/studies/sugandi_study.h"

#include <opencv2/core/mat.hpp>

#include <cstddef>
#include <string>
#include <vector>

namespace dewpoint::experiment {

/// Draws an image (CV_8UC3) like figures 2 and 3 of Sugandi et al. 2009. It shows five frames of a
/// clip: four evenly spaced frames, and the frame with the largest error with 100 particles. The
/// boxes and centers found with 100 particles (`few`, upper row) and 300 particles (`many`, lower
/// row) are red. The true box is white.
cv::Mat drawBoxFrames(const std::vector<cv::Mat>& images, const std::vector<ImageBox>& truth,
                      const BoxStudyRow& few, const BoxStudyRow& many);

/// Returns the figures of a clip as HTML: plots of x, y and error of the box centers over the
/// frames, and the image with the boxes of five frames (drawBoxFrames()).
std::string boxFiguresHtml(const BoxStudy& study, std::size_t clip);
/// Returns, for a clip, the file name of the image with the boxes of five frames (drawBoxFrames()).
std::string framesWithBoxesFileName(std::size_t clip);
/// Returns plots for a clip as HTML, like figure 1 of Sugandi et al. 2009: the color histograms of
/// the first box, which was given to the method, and of the box found halfway through the clip.
std::string boxHistogramsHtml(const BoxStudy& study, std::size_t clip);
/// Returns the color histograms of all clips as CSV, with one row per clip and bin. Bins that are
/// empty in both histograms of a clip are omitted.
std::string boxHistogramsCsv(const BoxStudy& study);
/// Returns the found boxes as CSV, with one row per clip, method and frame of the first run. The
/// truth is listed as a method.
std::string boxTracksCsv(const BoxStudy& study);

} // namespace dewpoint::experiment
